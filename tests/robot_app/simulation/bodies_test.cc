#include "robot_app/simulation/bodies.h"

#include <gtest/gtest.h>

#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

TEST(Bodies, DriveTheWayThatVelocityAndTimeGive) {
  Bodies bodies(MakeRoom(), {2, 0, 0});
  for (int i = 0; i < 500; ++i) bodies.Step(0.02, {0.8, 0});
  EXPECT_NEAR(bodies.robot().x, 10, 1e-3);
  EXPECT_NEAR(bodies.robot().y, 0, 1e-3);
  EXPECT_NEAR(bodies.velocity().linear, 0.8, 1e-4);
}

TEST(Bodies, DriveACircleBackToTheStart) {
  Bodies bodies(MakeRoom(), {10, -0.8, 0});
  const double turn = 0.5;
  const int steps = 628;
  for (int i = 0; i < steps; ++i) bodies.Step(2 * kPi / turn / steps, {0.4, turn});
  EXPECT_NEAR(bodies.robot().x, 10, 0.01);
  EXPECT_NEAR(bodies.robot().y, -0.8, 0.01);
  EXPECT_NEAR(bodies.robot().yaw, 0, 0.01);
}

TEST(Bodies, AWallStopsTheRobotHoweverLongTheStepAndFastTheRobot) {
  for (const double dt : {0.01, 0.02, 0.1, 0.5}) {
    for (const double heading : {0.0, 0.7, 1.57, 2.5, -1.0}) {
      Bodies bodies(MakeRoom(), {10, 0, heading});
      for (double t = 0; t < 20; t += dt) bodies.Step(dt, {3.0, 0});
      const Pose2 end = bodies.robot();
      EXPECT_GT(end.x, 0.32) << dt << " " << heading;
      EXPECT_LT(end.x, 19.68) << dt << " " << heading;
      EXPECT_LT(std::abs(end.y), 1.68) << dt << " " << heading;
      EXPECT_TRUE(bodies.touching());
    }
  }
}

TEST(Bodies, ABumpTakesTheVelocityAwayAndTheWayBackIsFree) {
  Bodies bodies(MakeRoom(), {19, 0, 0});
  for (int i = 0; i < 100; ++i) bodies.Step(0.02, {0.9, 0});
  EXPECT_NEAR(bodies.velocity().linear, 0, 1e-3);
  EXPECT_TRUE(bodies.touching());
  for (int i = 0; i < 100; ++i) bodies.Step(0.02, {-0.5, 0});
  EXPECT_LT(bodies.robot().x, 18.8);
  EXPECT_FALSE(bodies.touching());
}

TEST(Bodies, DoorsAndBoxesComeAndGo) {
  const Segment leaf{{12, -2}, {12, 2}};
  Bodies bodies(MakeRoom(), {10, 0, 0});
  bodies.SetDoor(0, leaf);
  for (int i = 0; i < 200; ++i) bodies.Step(0.02, {0.9, 0});
  EXPECT_LT(bodies.robot().x, 11.68);
  bodies.SetDoor(0, std::nullopt);
  bodies.SetPlace(1, Rectangle{{14, 0}, {1, 3.8}, 0});
  for (int i = 0; i < 300; ++i) bodies.Step(0.02, {0.9, 0});
  EXPECT_GT(bodies.robot().x, 13.0);
  EXPECT_LT(bodies.robot().x, 13.18);
  bodies.SetPlace(1, std::nullopt);
  for (int i = 0; i < 100; ++i) bodies.Step(0.02, {0.9, 0});
  EXPECT_GT(bodies.robot().x, 14);
}

TEST(Bodies, APersonWhoStandsStopsTheRobot) {
  Bodies bodies(MakeRoom(), {10, 0, 0});
  for (int i = 0; i < 200; ++i) {
    bodies.SetPerson(0, {{12, 0}, 0.25}, 0.02);
    bodies.Step(0.02, {0.9, 0});
  }
  EXPECT_NEAR(bodies.robot().x, 12 - 0.25 - kRobotRadius, 0.02);
}

}  // namespace
}  // namespace coppice::robot::simulation
