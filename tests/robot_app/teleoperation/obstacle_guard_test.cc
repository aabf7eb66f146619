#include "robot_app/teleoperation/obstacle_guard.h"

#include <gtest/gtest.h>

namespace coppice::robot::teleoperation {
namespace {

const GuardSettings kSettings;
const std::vector<Point2D> kWallAhead = {{1.0, -0.4}, {1.0, 0}, {1.0, 0.4}};

TEST(FreeWay, EndsWhereTheEdgeOfTheRobotTouches) {
  EXPECT_NEAR(FreeWay({0.4, 0}, kWallAhead, kSettings), 1.0 - 0.33, 0.05);
  EXPECT_EQ(FreeWay({-0.4, 0}, kWallAhead, kSettings), kSettings.look_ahead);
  EXPECT_EQ(FreeWay({0, 0.5}, kWallAhead, kSettings), kSettings.look_ahead);
}

TEST(FreeWay, FollowsTheArc) {
  const std::vector<Point2D> beside = {{1.0, 0.9}};
  EXPECT_EQ(FreeWay({0.4, 0}, beside, kSettings), kSettings.look_ahead);
  EXPECT_LT(FreeWay({0.4, 0.4}, beside, kSettings), 1.2);
}

TEST(Guard, LetsAFreeWayAlone) {
  const Velocity2D command = Guard({0.4, 0.2}, {}, kSettings);
  EXPECT_EQ(command.linear, 0.4);
  EXPECT_EQ(command.angular, 0.2);
}

TEST(Guard, SlowsDownOnTheSameArcAndStopsBeforeAWall) {
  const Velocity2D slower = Guard({0.8, 0.08}, kWallAhead, kSettings);
  EXPECT_GT(slower.linear, 0.2);
  EXPECT_LT(slower.linear, 0.7);
  EXPECT_NEAR(slower.angular / slower.linear, 0.1, 1e-9);
  const Velocity2D held = Guard({0.4, 0.3}, {{0.6, 0}}, kSettings);
  EXPECT_EQ(held.linear, 0);
  EXPECT_EQ(held.angular, 0.3);
}

TEST(Guard, AlwaysLetsTheRobotTurnAndDriveAwayFromWhatItTouches) {
  const std::vector<Point2D> touched = {{0.32, 0}};
  EXPECT_EQ(Guard({0, 0.5}, touched, kSettings).angular, 0.5);
  EXPECT_EQ(Guard({0.3, 0}, touched, kSettings).linear, 0);
  EXPECT_EQ(Guard({-0.4, 0}, touched, kSettings).linear, -kSettings.most_backwards);
}

TEST(Guard, ARobotThatBrakesAsItSaysNeverComesNearerThanTheDistance) {
  double x = 0;
  double speed = 0;
  constexpr double kTick = 0.05;
  for (int i = 0; i < 400; ++i) {
    const Velocity2D wish = Guard({0.4, 0}, {{3 - x, 0}}, kSettings);
    speed = LimitChange(speed, wish.linear, kSettings.deceleration, kTick);
    x += speed * kTick;
  }
  EXPECT_GT(x, 1.5);
  EXPECT_LT(x + kSettings.robot_radius, 3 - 0.25);
}

}  // namespace
}  // namespace coppice::robot::teleoperation
