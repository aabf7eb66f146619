// Faults of single programs and of what they say, one after the other in one running robot. The
// laser scanner has a driver of its own here, which wedges on request.
#include <gtest/gtest.h>

#include <csignal>
#include <memory>

#include "tests/support/folders.h"
#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

using coppice_msgs::RecoveryEvent;

const char kDriver[] = R"(processes:
  - name: laser_driver
    command: ["${bin}/laser_driver"]
    node: /laser_driver
    depends: [simulator]
)";

RigOptions Options() {
  RigOptions options;
  options.name = "node_faults";
  options.start = "2 0 0";
  options.variables = {{"speed", "1"}, {"seed", "7"}};
  options.programs = {{"laser_driver", BinaryFolder() + "/tests/bin/laser_driver"}};
  // On its way already, so that nothing but the fault changes anything.
  options.edits = {
      {"robot.yaml", "\"_speed:=", "\"/scan:=/simulation/scan\", \"_speed:="},
      {"robot.yaml", "processes:\n", kDriver},
      {"robot.yaml", "operating: [simulator,", "operating: [simulator, laser_driver,"},
      {"robot.yaml", "processes: [simulator,", "processes: [simulator, laser_driver,"},
      // The same driver is broken more often than it would be in life.
      {"robot.yaml", "restart_intensity: {restarts: 3,", "restart_intensity: {restarts: 10,"},
      {"robot.yaml", "back_off: {first: 5,", "back_off: {first: 1,"},
      {"monitors.yaml", "topic: /scan, node: /simulator", "topic: /scan, node: /laser_driver"}};
  return options;
}

class NodeFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options());
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }

  // The program dies and is back by a restart of it alone.
  void ExpectRestartOf(const std::string& process, FaultCase& fault, double patience = 60) {
    fault.ExpectRestarted(process, patience);
    fault.ExpectNominal();
    fault.ExpectOnlyRestarted({process});
    fault.ExpectNobodyAsked();
  }
  // The same, by the monitor tree, which has said so.
  void ExpectTreeRestarts(const std::string& process, FaultCase& fault) {
    fault.ExpectRecovery("restart node", "/" + process, RecoveryEvent::SUCCEEDED);
    ExpectRestartOf(process, fault);
  }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> NodeFaults::rig_;

TEST_F(NodeFaults, ADeadNodeIsRestarted) {
  FaultCase fault(*rig_, "dead node", "SIGKILL to `/docking`");
  ASSERT_TRUE(rig_->Inject("kill_node", "/docking"));
  fault.ExpectRestartBegun("docking", 2);
  ExpectRestartOf("docking", fault);
}

TEST_F(NodeFaults, AHungNodeIsRestarted) {
  FaultCase fault(*rig_, "hung node", "SIGSTOP to `/navigation`");
  ASSERT_TRUE(rig_->Inject("hang_node", "/navigation"));
  fault.ExpectDetected("node", "/navigation", 3);
  ExpectTreeRestarts("navigation", fault);
}

TEST_F(NodeFaults, ASilentTopicRestartsItsPublisherThoughThatAnswersPings) {
  FaultCase fault(*rig_, "silent topic", "the laser driver says nothing, but answers");
  ASSERT_TRUE(rig_->Signal("laser_driver", SIGUSR1));
  fault.ExpectDetected("topic", "/scan", 3);
  ExpectTreeRestarts("laser_driver", fault);
}

TEST_F(NodeFaults, ASlowTopicRestartsItsPublisher) {
  FaultCase fault(*rig_, "slow topic", "a quarter of the scans");
  ASSERT_TRUE(rig_->Signal("laser_driver", SIGUSR2));
  fault.ExpectDetected("topic", "/scan", 4);
  ExpectTreeRestarts("laser_driver", fault);
}

TEST_F(NodeFaults, ATooFastTopicRestartsItsPublisher) {
  FaultCase fault(*rig_, "too fast topic", "three times the scans");
  ASSERT_TRUE(rig_->Signal("laser_driver", SIGRTMIN));
  fault.ExpectDetected("topic", "/scan", 4);
  ExpectTreeRestarts("laser_driver", fault);
}

TEST_F(NodeFaults, ABlindScannerIsRestartedThoughItsScansCome) {
  FaultCase fault(*rig_, "blind scanner", "the laser driver's scans are NaN on all beams");
  ASSERT_TRUE(rig_->Signal("laser_driver", SIGRTMIN + 1));
  fault.ExpectDetected("topic", "/scan", 4);
  ExpectTreeRestarts("laser_driver", fault);
}

TEST_F(NodeFaults, AMonitorThatIsKilledIsRestarted) {
  FaultCase fault(*rig_, "monitor killed", "SIGKILL to `/topic_monitor`");
  ASSERT_TRUE(rig_->Inject("kill_node", "/topic_monitor"));
  fault.ExpectRestartBegun("topic_monitor", 2);
  ExpectRestartOf("topic_monitor", fault);
}

// Nobody pings the one who pings: its silence is seen.
TEST_F(NodeFaults, TheNodeMonitorThatHangsIsRestarted) {
  FaultCase fault(*rig_, "node monitor hung", "SIGSTOP to `/node_monitor`");
  ASSERT_TRUE(rig_->Inject("hang_node", "/node_monitor"));
  fault.ExpectDetected("node", "/node_monitor", 4);
  ExpectTreeRestarts("node_monitor", fault);
}

TEST_F(NodeFaults, TheAggregatorThatIsKilledIsRestarted) {
  FaultCase fault(*rig_, "aggregator killed", "SIGKILL to `/health_aggregator`");
  ASSERT_TRUE(rig_->Inject("kill_node", "/health_aggregator"));
  fault.ExpectRestartBegun("health_aggregator", 2);
  ExpectRestartOf("health_aggregator", fault);
}

}  // namespace
}  // namespace coppice::robot
