// Faults on the way, in a robot that shuttles in the corridor at six times real time. Times are
// ROS time, as the navigation's and the localization's own are.
#include <gtest/gtest.h>

#include <memory>

#include "tests/support/folders.h"
#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

using coppice_msgs::HealthEntry;
using coppice_msgs::HelpRequest;
using coppice_msgs::RecoveryEvent;

constexpr double kFoundWithin = 0.5;  // m

RigOptions Options(const std::string& name, const std::string& application) {
  RigOptions options;
  options.name = name;
  options.start = "4 0 0";
  options.variables = {{"speed", "4"},
                       {"seed", "5"},
                       {"application", SourceFolder() + "/tests/system/trees/" + application}};
  // People who never answer, and a robot that does not wait long for them.
  options.edits = {{"supervisors.yaml", "remind: 120", "remind: 3"},
                   {"supervisors.yaml", "next: 300", "next: 4"},
                   {"supervisors.yaml", "deadline: 1800", "deadline: 10"},
                   {"supervisors.yaml", "settle: 10", "settle: 2"}};
  return options;
}

class DriveFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options("drive_faults", "shuttle.xml"));
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }

  // Until it drives east and the place corridor_east (x = 30) is well ahead.
  static bool WaitUntilHeadingEast() {
    double before = 1e9;
    return rig_->WaitFor(
        [&before](const RobotState& state) {
          const double x = state.truth().x;
          const bool eastward = x > before + 0.2;
          before = eastward ? 1e9 : std::min(before, x);
          return eastward && x < 20;
        },
        180);
  }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> DriveFaults::rig_;

TEST_F(DriveFaults, ABlockedCorridorIsWaitedForAndDrivenOn) {
  ASSERT_TRUE(WaitUntilHeadingEast());
  FaultCase fault(*rig_, "blocked corridor",
                  "a box in the corridor, until the robot has waited in vain");
  ASSERT_TRUE(rig_->Inject("block_corridor", "corridor_east"));
  // It has to drive there before it can stand before the box.
  fault.ExpectDetected("navigation", "progress", 90);
  fault.ExpectRecovery("wait and retry", "navigation", RecoveryEvent::FAILED);
  ASSERT_TRUE(rig_->Inject("clear_corridor", "corridor_east"));
  fault.ExpectRecovery("move backwards", "navigation", RecoveryEvent::SUCCEEDED);
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({});
  fault.ExpectNobodyAsked();
}

TEST_F(DriveFaults, WhenAllSupervisorsAreAwayTheRobotSaysSoAndLosesNothing) {
  ASSERT_TRUE(WaitUntilHeadingEast());
  FaultCase fault(*rig_, "supervisor away",
                  "a box in the corridor that stays, and nobody who answers");
  ASSERT_TRUE(rig_->Inject("block_corridor", "corridor_east"));
  fault.ExpectDetected("navigation", "progress", 90);
  ASSERT_TRUE(fault.ExpectAsked("navigation", 120));
  fault.ExpectAskedInTurn("navigation", {"First supervisor", "Second supervisor"});
  fault.ExpectRequestEnded("navigation", HelpRequest::NOBODY);
  ASSERT_TRUE(rig_->Inject("clear_corridor", "corridor_east"));
  fault.AddRecovery("drives on when the way is free");
  const double x = rig_->With([](const RobotState& state) { return state.truth().x; });
  EXPECT_TRUE(rig_->WaitFor([x](const RobotState& s) { return s.truth().x > x + 2; }, 180));
  fault.ExpectNominal(180);
  fault.ExpectOnlyRestarted({});
}

// The odometry does not notice that it is carried. It stands, and so sees nothing more by itself.
TEST(KidnappedRobot, LooksAroundAndFindsItself) {
  RobotRig rig(Options("kidnapped_robot", "stand.xml"));
  ASSERT_TRUE(rig.Start());
  FaultCase fault(rig, "kidnapped robot", "while it stands it is lifted into the hall");
  ASSERT_TRUE(rig.Inject("kidnap", "hall_north"));
  fault.ExpectDetected("localization", "phase", 20);
  fault.ExpectRecovery("slow rotate", "localization", RecoveryEvent::SUCCEEDED);
  fault.ExpectNominal(180);
  const double nominal = rig.Now().ros;
  ASSERT_TRUE(rig.WaitFor([&](const RobotState& s) { return s.compared_at() > nominal; }, 30));
  EXPECT_LT(rig.With([](const RobotState& s) { return s.deviation(); }), kFoundWithin);
  fault.AddRecovery("within 0.5 m of the truth");
  fault.ExpectOnlyRestarted({});
  fault.ExpectNobodyAsked();
}

}  // namespace
}  // namespace coppice::robot
