// Docking and undocking of the simulated robot, without ROS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/robot_app/docking/docking_robot.h"
#include "tests/robot_app/docking/docking_study.h"

namespace coppice::robot::docking {
namespace {

using simulation::Pose2;
using Phase = DockController::Phase;

class DockingInWorld : public testing::Test {
 protected:
  void Place(const std::optional<Pose2>& start, double charge = 0.5) {
    simulation::WorldOptions options;
    options.start = start;
    options.state_of_charge = charge;
    robot_.emplace(floor_, options);
    robot_->Stand(0.5);
  }
  simulation::World& world() { return robot_->world(); }
  DockController& controller() { return robot_->controller(); }
  void Dock(double offset = 0, int attempts = 0) {
    controller().StartDocking(robot_->Input(), offset, attempts);
    EXPECT_TRUE(robot_->Run(300));
  }

  simulation::Floor floor_ = navigation::InstituteFloor();
  std::optional<DockingRobot> robot_;
};

TEST_F(DockingInWorld, DocksFromPlacesNearTheStagingPose) {
  for (const Pose2& start : {floor_.staging, Pose2{0.3, 0.6, 1}, Pose2{-0.6, -0.5, -2}}) {
    SCOPED_TRACE(testing::Message() << start.x << ' ' << start.y << ' ' << start.yaw);
    Place(start);
    Dock();
    EXPECT_EQ(controller().phase(), Phase::kDone) << controller().message();
    EXPECT_TRUE(world().docked());
    EXPECT_TRUE(world().battery().charging());
    EXPECT_LT(std::abs(navigation::PoseOf(world()).y), 0.02);
  }
}

TEST_F(DockingInWorld, UndocksAndDocksAgain) {
  Place(std::nullopt);
  ASSERT_TRUE(world().docked());
  controller().StartUndocking(robot_->Input());
  ASSERT_TRUE(robot_->Run(60));
  ASSERT_EQ(controller().phase(), Phase::kDone) << controller().message();
  EXPECT_FALSE(world().docked());
  Dock();
  EXPECT_EQ(controller().phase(), Phase::kDone) << controller().message();
  EXPECT_TRUE(world().docked());
}

TEST_F(DockingInWorld, FindsBentContactsByTryingFromAside) {
  for (const double moved : {0.06, -0.06}) {
    Place(floor_.staging);
    ASSERT_TRUE(world().SetContactsOffset(moved));
    bool charging = false;
    for (const double offset : {0.0, 0.04, -0.04, 0.08, -0.08}) {
      if (charging) break;
      Dock(offset, 1);
      charging = controller().phase() == Phase::kDone;
    }
    EXPECT_TRUE(charging) << moved << ": " << controller().message();
    EXPECT_TRUE(world().docked());
  }
}

TEST_F(DockingInWorld, AStationThatWasMovedByHalfAMetreIsFoundWithoutTryingBlind) {
  for (const Pose2& moved : {Pose2{-0.2, 0.45, -0.35}, Pose2{-0.2, -0.45, 0.35}}) {
    Place(floor_.staging);
    ASSERT_TRUE(world().MoveStation(moved));
    robot_->Stand(0.3);
    Dock(0, 1);
    EXPECT_EQ(controller().phase(), Phase::kDone) << controller().message();
    EXPECT_TRUE(world().docked());
    EXPECT_EQ(controller().failed_attempts(), 0);
  }
}

TEST_F(DockingInWorld, WithoutItsLandmarkTheStationIsNotDrivenInto) {
  Place(floor_.staging);
  ASSERT_TRUE(world().SetLandmark(false));
  robot_->Stand(0.3);
  Dock();
  EXPECT_EQ(controller().phase(), Phase::kFailed);
  EXPECT_THAT(controller().message(), testing::HasSubstr("is not seen"));
  EXPECT_LT(Distance(navigation::PoseOf(world()), ToPose2D(floor_.staging)), 0.05);
}

TEST_F(DockingInWorld, ContactWithoutCurrentEndsInTheLadder) {
  Place(floor_.staging);
  ASSERT_TRUE(world().SetChargerOn(false));
  Dock(0, 1);
  EXPECT_EQ(controller().phase(), Phase::kFailed);
  EXPECT_THAT(controller().message(), testing::HasSubstr("no charging current"));
}

// A few of the dockings of `./dev bench docking`: with noise, worn wheels, a wrong idea of where
// the robot is, a station that was moved, and passers-by.
TEST(DockingStudy, EndsWithCurrentWithinAMinute) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const DockingOutcome outcome = DockOnce(seed);
    EXPECT_TRUE(outcome.docked) << seed << ": " << outcome.message;
  }
}

TEST_F(DockingInWorld, ABoxBeforeTheStationFailsWithoutATouch) {
  Place(floor_.staging);
  ASSERT_TRUE(world().SetPlaceBlocked("dock_front", true));
  robot_->Stand(0.2);
  Dock();
  EXPECT_EQ(controller().phase(), Phase::kFailed);
  EXPECT_THAT(controller().message(), testing::HasSubstr("obstacle"));
  EXPECT_FALSE(world().touching());
}

}  // namespace
}  // namespace coppice::robot::docking
