#include "robot_app/docking/dock_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::docking {
namespace {

constexpr DockSettings kSettings;

TEST(DockPath, EndsAtTheContactsStraightOnTheAxis) {
  for (const Pose2D& from : {Pose2D{-1.6, 0, 0}, Pose2D{-2, 0.8, 2}, Pose2D{-0.6, -0.6, -1}}) {
    const auto path = PlanDockPath(from, 0, {}, kSettings);
    ASSERT_TRUE(path);
    const Pose2D end = path->At(path->length());
    EXPECT_NEAR(end.x, 0, 1e-4);
    EXPECT_NEAR(end.y, 0, 1e-4);
    EXPECT_NEAR(end.yaw, 0, 1e-4);
    EXPECT_GE(path->straight, 0.45);
  }
}

TEST(DockPath, EndsAsFarAsideAsItIsTold) {
  const auto path = PlanDockPath({-1.6, 0, 0}, 0.08, {}, kSettings);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->At(path->length()).y, 0.08, 1e-4);
}

TEST(DockPath, LeadsRoundWhatStandsInTheWay) {
  const std::vector<Point2D> post = {{-1.3, 0}};
  const auto path = PlanDockPath({-2.2, 0, 0}, 0, post, kSettings);
  ASSERT_TRUE(path);
  for (double way = 0; way < path->length(); way += 0.02) {
    const Pose2D at = path->At(way);
    ASSERT_GT(std::hypot(at.x + 1.3, at.y), kSettings.robot_radius);
  }
}

TEST(DockPath, ThereIsNoneWhenSomethingStandsBeforeTheContacts) {
  EXPECT_FALSE(PlanDockPath({-1.6, 0, 0}, 0, {{-0.2, 0.1}}, kSettings));
}

TEST(DockPath, NoiseDoesNotStopWhoDrivesAsFarFromAWallAsWasPlanned) {
  const auto path = PlanDockPath({-1.6, 0, 0}, 0, {}, kSettings);
  ASSERT_TRUE(path);
  const std::vector<Point2D> wall = {{-0.6, kSettings.robot_radius + kPlannedMargin - 0.02}};
  EXPECT_TRUE(IsBlocked(*path, 0, path->length(), wall, kSettings));
  EXPECT_FALSE(IsBlocked(*path, 0, path->length(), wall, kSettings, kDrivenMargin));
  const std::vector<Point2D> leg = {{-0.6, kSettings.robot_radius}};
  EXPECT_TRUE(IsBlocked(*path, 0, path->length(), leg, kSettings, kDrivenMargin));
}

TEST(DockPath, TheStationIsNoObstacle) {
  const LandmarkShape shape;
  const std::vector<Point2D> seen = {{0.43, 0}, {0.48, 0.17}, {0.52, -0.33}, {-0.5, 0.5}};
  const auto others = WithoutStation(seen, {}, shape);
  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0].y, 0.5);
}

}  // namespace
}  // namespace coppice::robot::docking
