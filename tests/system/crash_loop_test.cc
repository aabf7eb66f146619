// A program that others depend on crashes soon after every start, whoever restarts it: the crash
// loop that no restart of a node ends. The process supervisor must recognise it, stop restarting it
// alone, climb, and at last ask a person. The limits are those of the shipped robot. Real time; the
// figures are wall time, because a new ROS master begins ROS time anew.
#include <coppice_msgs/RestartProcess.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>

#include "tests/support/folders.h"
#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

using coppice_msgs::ProcessState;

constexpr char kVictim[] = "odometry_filter";
constexpr char kDamage[] = "/crash_loop/coppice_odometry_filter";
constexpr unsigned kMostRestarts = 3;
constexpr double kEscalatedWithin = 60;   // s
constexpr double kAskedWithin = 10 * 60;  // s
constexpr double kQuiet = 10;             // s, ROS time

RigOptions Options() {
  RigOptions options;
  options.name = "crash_loop";
  options.start = "2 0 0";
  options.variables = {{"speed", "1"}, {"seed", "2"}};
  options.programs = {{"coppice-odometry-filter", BinaryFolder() + "/tests/bin/crash_loop"}};
  return options;
}

ProcessState Victim(const RobotState& state) {
  const auto found = state.processes().find(kVictim);
  return found == state.processes().end() ? ProcessState() : found->second;
}

// A ROS master answers, and knows nothing of the damage.
bool IsHealed() {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = kDamage;
  return ros::master::execute("hasParam", request, response, payload, false) &&
         !static_cast<bool>(payload);
}

// It was ended because the victim was restarted in vain, after a crash or at the monitors' request.
bool IsTakenAlong(const RobotState& state, const std::string& dependent) {
  for (const Event& event : state.events()) {
    if (event.kind == Event::Kind::kProcess && event.subject == dependent &&
        event.value == ProcessState::STARTING && event.text.find("odometry_filter ") == 0 &&
        event.text.find("; restarted 3 times") != std::string::npos) {
      return true;
    }
  }
  return false;
}

// The supervisor itself asks, by a program of its own: perhaps nothing else runs any more.
bool PersonIsCalled(const RobotRig& rig) {
  const std::string told = rig.Logged("on_given_up");
  return told.find("has given up odometry_filter") != std::string::npos &&
         told.find("failed again after a restart of the stack") != std::string::npos;
}

bool IsSettled(const RobotState& state) {
  for (const auto& [name, process] : state.processes()) {
    const int is = process.state;
    if (is != ProcessState::READY && is != ProcessState::STOPPED && is != ProcessState::GIVEN_UP) {
      return false;
    }
  }
  return true;
}

std::map<std::string, int> Pids(const RobotState& state) {
  std::map<std::string, int> pids;
  for (const auto& [name, process] : state.processes()) pids[name] = process.pid;
  return pids;
}

// Waits until nothing changes any more; from then on no program is started or ended for ten
// seconds of ROS time, and the robot stands.
void ExpectQuiet(RobotRig& rig) {
  ASSERT_TRUE(rig.WaitFor(IsSettled, 60));
  std::map<std::string, int> pids;
  StampedPoint stands;
  double since = -kQuiet;
  EXPECT_TRUE(rig.WaitFor(
      [&](const RobotState& state) {
        const StampedPoint& now = state.truth();
        const bool moves = std::hypot(now.x - stands.x, now.y - stands.y) > 0.02;
        if (since < 0 || moves || Pids(state) != pids) {
          pids = Pids(state);
          stands = now;
          since = state.now().ros;
        }
        return state.now().ros >= since + kQuiet;
      },
      5 * kQuiet));
}

class CrashLoop : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options());
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> CrashLoop::rig_;

// The damage lies on the ROS parameter server, so only a new ROS master heals it.
TEST_F(CrashLoop, IsRecognisedAndEndedByARestartOfTheWholeStack) {
  FaultCase fault(*rig_, "crash loop of the odometry filter",
                  "it crashes 1.5 to 3 s after each start, until the ROS master is new");
  fault.CountWallTime();
  const unsigned before = rig_->With(Victim).restarts;
  ros::param::set(kDamage, true);
  ASSERT_TRUE(rig_->Signal(kVictim, SIGKILL));
  unsigned restarts = 0;
  ASSERT_TRUE(rig_->WaitFor(
      [&restarts](const RobotState& state) {
        const ProcessState victim = Victim(state);
        if (victim.escalation == ProcessState::GROUP) restarts = victim.restarts;
        return victim.escalation >= ProcessState::CLOSURE;
      },
      240))
      << rig_->TimelineSince(fault.begin());
  fault.SetDetected("restarts of odometry_filter", kEscalatedWithin);
  EXPECT_LE(restarts - before, kMostRestarts);
  for (const char* dependent : {"localization", "navigation"}) {
    EXPECT_TRUE(rig_->WaitFor([&](const RobotState& s) { return IsTakenAlong(s, dependent); }, 30))
        << dependent;
  }
  ASSERT_TRUE(rig_->WaitFor([](const RobotState&) { return IsHealed(); }, 240));
  fault.AddRecovery("restart of it, then with its dependents, then of the whole stack");
  EXPECT_TRUE(fault.ExpectNominal(120));
  fault.ExpectNobodyAsked();
}

// It comes back before the restart of the whole stack is forgotten.
TEST_F(CrashLoop, ThatNothingEndsStopsTheRobotAndAsksAPerson) {
  FaultCase fault(*rig_, "crash loop that comes back",
                  "the same, until somebody repairs it, right after the restart of the stack");
  fault.CountWallTime();
  const auto damage = rig_->folder() / "bin/coppice-odometry-filter.damage";
  std::ofstream(damage) << "damaged\n";
  ASSERT_TRUE(rig_->Signal(kVictim, SIGKILL));
  ASSERT_TRUE(
      rig_->WaitFor([](const RobotState&) { return PersonIsCalled(*rig_); }, 2 * kAskedWithin));
  fault.SetDetected("restarts of odometry_filter", kAskedWithin);
  fault.SetAsked();
  EXPECT_TRUE(rig_->WaitFor(
      [](const RobotState& state) {
        return Victim(state).state == ProcessState::GIVEN_UP &&
               state.configuration() == "safe_stop" && state.Pid("navigation") == 0;
      },
      60));
  fault.AddRecovery("safe stop, a person is called");
  ExpectQuiet(*rig_);

  std::filesystem::remove(damage);
  coppice_msgs::RestartProcess repaired;
  repaired.request.name = "all";
  ASSERT_TRUE(ros::service::call("/supervisor/reset", repaired));
  EXPECT_TRUE(repaired.response.ok) << repaired.response.message;
  EXPECT_TRUE(fault.ExpectNominal(120));
}

}  // namespace
}  // namespace coppice::robot
