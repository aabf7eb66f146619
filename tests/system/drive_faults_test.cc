// Faults on the way, in a robot that shuttles in the corridor at six times real time. Times are
// ROS time, as the navigation's and the localization's own are.
#include <gtest/gtest.h>

#include <memory>

#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

using coppice_msgs::HealthEntry;
using coppice_msgs::HelpRequest;

RigOptions Options() {
  RigOptions options;
  options.name = "drive_faults";
  options.start = "4 0 0";
  options.variables = {
      {"speed", "6"},
      {"seed", "5"},
      {"application", std::string(COPPICE_SOURCE_DIR) + "/tests/system/trees/shuttle.xml"}};
  // People who never answer, and a robot that does not wait long for them.
  options.edits = {{"supervisors.yaml", "remind: 120", "remind: 3"},
                   {"supervisors.yaml", "next: 300", "next: 6"},
                   {"supervisors.yaml", "deadline: 1800", "deadline: 15"},
                   {"supervisors.yaml", "settle: 10", "settle: 2"}};
  return options;
}

class DriveFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options());
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }

  // Until it drives east and the place corridor_east (x = 30) is well ahead.
  static bool WaitUntilHeadingEast() {
    double before = 1e9;
    return rig_->WaitFor(
        [&before](const RobotState& state) {
          const bool eastward = state.x() > before + 0.2;
          before = eastward ? 1e9 : std::min(before, state.x());
          return eastward && state.x() < 20;
        },
        180);
  }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> DriveFaults::rig_;

TEST_F(DriveFaults, ABlockedCorridorIsWaitedForAndDrivenOn) {
  ASSERT_TRUE(WaitUntilHeadingEast());
  FaultCase fault(*rig_, "blocked corridor", "a box in the corridor for 55 s");
  ASSERT_TRUE(rig_->Inject("block_corridor", "corridor_east", 0, 55));
  // It has to drive there before it can stand before the box.
  fault.ExpectDetected("navigation", "progress", 90);
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({});
  fault.ExpectNobodyAsked();
  fault.set_recovery("wait and retry, move backwards");
}

// The odometry does not notice it.
TEST_F(DriveFaults, AKidnappedRobotFindsItself) {
  FaultCase fault(*rig_, "kidnapped robot", "it is lifted into the hall");
  ASSERT_TRUE(rig_->Inject("kidnap", "hall_north"));
  fault.ExpectLevel("localization", "phase", HealthEntry::WARN, 30);
  fault.ExpectNominal(180);
  fault.ExpectOnlyRestarted({"localization"});
  fault.set_recovery("search of the whole map, slow turn if that is not enough");
}

TEST_F(DriveFaults, WhenAllSupervisorsAreAwayTheRobotSaysSoAndLosesNothing) {
  ASSERT_TRUE(WaitUntilHeadingEast());
  FaultCase fault(*rig_, "supervisor away",
                  "a box in the corridor that stays, and nobody who answers");
  ASSERT_TRUE(rig_->Inject("block_corridor", "corridor_east"));
  fault.ExpectDetected("navigation", "progress", 90);
  ASSERT_TRUE(fault.ExpectAsked("navigation", 120));
  EXPECT_TRUE(rig_->WaitFor(
      [](const RobotState& state) {
        for (const Event& event : state.events()) {
          if (event.kind == Event::Kind::kRequest && event.value == HelpRequest::NOBODY)
            return true;
        }
        return false;
      },
      60));
  ASSERT_TRUE(rig_->Inject("clear_corridor", "corridor_east"));
  fault.ExpectNominal(180);
  fault.ExpectOnlyRestarted({});
  fault.set_recovery("asks one after the other; drives on when the way is free");
}

}  // namespace
}  // namespace coppice::robot
