// Faults of those who watch the others: the program of the trees, and the process supervisor.
#include <coppice_msgs/RestartProcess.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <csignal>
#include <memory>

#include "robot_app/common/node_probe.h"
#include "tests/robot_app/processes/shut_down_node.h"
#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

constexpr double kNominalWithin = 15;  // s, of what docs/faults.md promises

RigOptions Options() {
  RigOptions options;
  options.name = "watcher_faults";
  options.start = "2 0 0";
  options.variables = {{"speed", "1"}, {"seed", "11"}};
  return options;
}

class WatcherFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options());
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }
  // What the case before cost counts for nothing: a second restart in a minute waits for longer.
  void SetUp() override {
    coppice_msgs::RestartProcess reset;
    reset.request.name = "all";
    ASSERT_TRUE(ros::service::call("/supervisor/reset", reset));
    ASSERT_TRUE(reset.response.ok) << reset.response.message;
  }

  // The supervisor brings the trees back by its own decision; nobody else could.
  void ExpectTreesBack(FaultCase& fault) {
    fault.ExpectRestarted("robot");
    fault.ExpectNominalWithin(kNominalWithin);
    fault.ExpectOnlyRestarted({"robot"});
    fault.ExpectNobodyAsked();
  }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> WatcherFaults::rig_;

TEST_F(WatcherFaults, TreesThatHangAreRestarted) {
  FaultCase fault(*rig_, "trees hung", "SIGSTOP to `/coppice_robot`");
  ASSERT_TRUE(rig_->Signal("robot", SIGSTOP));
  fault.ExpectDetected("node", "/coppice_robot", 4);
  fault.ExpectRestartBegun("robot", 9);
  ExpectTreesBack(fault);
}

TEST_F(WatcherFaults, TreesThatWereShutDownOverTheNetworkAreRestarted) {
  FaultCase fault(*rig_, "trees shut down", "XML-RPC `shutdown` to `/coppice_robot`");
  ASSERT_TRUE(processes::ShutDownNode(*ParseUri(ros::master::getURI()), "/coppice_robot"));
  fault.ExpectRestartBegun("robot", 4);
  ExpectTreesBack(fault);
}

// The clock of all programs stands while it is away, and goes back with it.
TEST_F(WatcherFaults, ASimulatorThatIsRestartedIsNoEmptyBattery) {
  FaultCase fault(*rig_, "clock goes back", "SIGKILL to `/simulator`, whose time begins anew");
  fault.CountWallTime();
  ASSERT_TRUE(rig_->Signal("simulator", SIGKILL));
  fault.ExpectRestarted("simulator");
  fault.ExpectNominal();
  fault.ExpectNobodyAsked();
}

// The kernel of a stopped program still takes connections: whoever calls it gets no answer.
TEST_F(WatcherFaults, APersonIsAskedWhenTheSupervisorHangs) {
  FaultCase fault(*rig_, "supervisor hung",
                  "SIGSTOP to `coppice-supervisor`, then SIGKILL to `/localization`");
  const int localization =
      rig_->With([](const RobotState& s) { return s.ReadyPid("localization"); });
  ASSERT_GT(localization, 0);
  kill(rig_->supervisor_pid(), SIGSTOP);
  kill(localization, SIGKILL);
  fault.ExpectDetected("supervisor", "/processes", 24);
  fault.ExpectAsked("supervisor", 30);
  kill(rig_->supervisor_pid(), SIGCONT);
  fault.ExpectRestarted("localization");
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({"localization"});
}

}  // namespace
}  // namespace coppice::robot
