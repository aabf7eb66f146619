#include "robot_app/navigation/follower.h"

#include <gtest/gtest.h>

#include "robot_app/navigation/planner.h"
#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::navigation {
namespace {

constexpr double kStep = 0.05;

std::vector<Point2D> Line(Point2D from, Point2D to) {
  std::vector<Point2D> points;
  for (int i = 0; i <= 100; ++i) {
    points.push_back({from.x + (to.x - from.x) * i / 100, from.y + (to.y - from.y) * i / 100});
  }
  return points;
}

struct Trip {
  bool reached = false;
  double seconds = 0;
  double clearance = HUGE_VAL;  // least
  double error = 0;             // greatest distance from the path
  Pose2D pose;
};

// Drives an ideal unicycle on the floor until it has reached the end of a planned path.
Trip DriveOn(const OccupancyGrid& floor, Pose2D pose, const Pose2D& goal,
             const FollowerSettings& settings = {}) {
  Costmap costmap;
  costmap.Update(floor);
  const Plan plan = FindPath(costmap, {pose.x, pose.y}, {goal.x, goal.y});
  EXPECT_EQ(plan.status, PlanStatus::kOk) << plan.message;
  Trip run;
  if (plan.status != PlanStatus::kOk) return run;
  Follower follower(settings);
  follower.SetPath(SmoothPath(costmap, plan.points), goal.yaw);
  Velocity2D last;
  for (run.seconds = 0; run.seconds < 120 && !run.reached; run.seconds += kStep) {
    const LaserScan scan = ScanOf(floor, pose, run.seconds);
    const Follower::Command command = follower.Update(pose, PointsInBase(scan, 3), kStep);
    EXPECT_LE(std::abs(command.velocity.linear - last.linear), 0.6 * kStep + 1e-9);
    EXPECT_LE(std::abs(command.velocity.angular - last.angular), 2.4 * kStep + 1e-9);
    EXPECT_LE(command.velocity.linear, settings.max_speed + 1e-9);
    last = command.velocity;
    pose = Advance(pose, command.velocity, kStep);
    run.reached = command.reached;
    run.clearance = std::min(run.clearance, Clearance(floor, pose));
    run.error = std::max(run.error, follower.tracking_error());
  }
  run.pose = pose;
  return run;
}

TEST(FreeDistance, EndsWhereTheDiscTouchesAPoint) {
  EXPECT_NEAR(FreeDistance({{2, 0}}, 0, 0.35, 3), 1.65, 0.05);
  EXPECT_NEAR(FreeDistance({{2, 0.36}}, 0, 0.35, 3), 3, 1e-9);
  EXPECT_NEAR(FreeDistance({}, 0.5, 0.35, 1.5), 1.5, 1e-9);
  EXPECT_NEAR(FreeDistance({{-2, 0}}, 0, 0.35, -3), 1.65, 0.05);
}

TEST(FreeDistance, FollowsTheArc) {
  // A quarter of a circle of radius 1 to the left ends at (1, 1).
  EXPECT_LT(FreeDistance({{1, 1.2}}, 1, 0.35, 2), 1.5);
  EXPECT_NEAR(FreeDistance({{2, 0}}, 1, 0.35, 1.5), 1.5, 1e-9);
}

TEST(FreeDistance, LetsTheDiscLeaveWhatItTouches) {
  EXPECT_NEAR(FreeDistance({{-0.2, 0.1}}, 0, 0.35, 1), 1, 1e-9);
  EXPECT_NEAR(FreeDistance({{0.2, 0.1}}, 0, 0.35, 1), 0, 1e-9);
}

TEST(Follower, DrivesALongCorridor) {
  OccupancyGrid floor = EmptyRoom(20, 2.5);
  const Trip run = DriveOn(floor, {1, 1.25, 0}, {18, 1.25, 0});
  EXPECT_TRUE(run.reached);
  EXPECT_NEAR(run.pose.x, 18, 0.15);
  EXPECT_LT(run.error, 0.05);
  EXPECT_LT(run.seconds, 17 / 0.7 + 6);
}

TEST(Follower, DrivesNoFasterThanItIsLimitedTo) {
  Follower follower;
  follower.SetPath(Line({0, 0}, {9, 0}), 0);
  follower.LimitSpeed(0.25);
  double speed = 0;
  for (int i = 0; i < 40; ++i) speed = follower.Update({0, 0, 0}, {}, kStep).velocity.linear;
  EXPECT_NEAR(speed, 0.25, 1e-9);
  follower.LimitSpeed(HUGE_VAL);
  for (int i = 0; i < 40; ++i) speed = follower.Update({0, 0, 0}, {}, kStep).velocity.linear;
  EXPECT_GT(speed, 0.6);
}

TEST(Follower, PassesADoorwayOfOneMetre) {
  OccupancyGrid floor = EmptyRoom(8, 8);
  Fill(floor, {0, 3.9}, {3.5, 4.1});
  Fill(floor, {4.5, 3.9}, {8, 4.1});
  const Trip run = DriveOn(floor, {1, 2.6, 0}, {7, 6.5, M_PI / 2});
  EXPECT_TRUE(run.reached);
  EXPECT_GT(run.clearance, 0.35);
  EXPECT_NEAR(NormalizeAngle(run.pose.yaw - M_PI / 2), 0, 0.15);
}

TEST(Follower, DrivesAroundAnObstacle) {
  OccupancyGrid floor = EmptyRoom(10, 4);
  Fill(floor, {4.5, 0}, {5.5, 2.2});
  const Trip run = DriveOn(floor, {1, 1, M_PI}, {9, 1, -M_PI / 2});
  EXPECT_TRUE(run.reached);
  EXPECT_GT(run.clearance, 0.35);
  EXPECT_LT(run.error, 0.15);
}

TEST(Follower, TurnsOnTheSpotBeforeItSetsOffBackwards) {
  Follower follower;
  follower.SetPath(Line({0, 0}, {-5, 0.5}), 0);
  for (int i = 0; i < 10; ++i) {
    const Velocity2D velocity = follower.Update({0, 0, 0}, {}, kStep).velocity;
    EXPECT_EQ(velocity.linear, 0);
    EXPECT_GT(velocity.angular, 0);
  }
}

TEST(Follower, StopsBeforeAnObstacleAndSaysSo) {
  Follower follower;
  follower.SetPath(Line({0, 0}, {5, 0}), 0);
  Pose2D pose{0, 0, 0};
  Follower::Command command;
  for (int i = 0; i < 400; ++i) {
    command = follower.Update(pose, {RelativeTo(pose, Point2D{3, 0.1})}, kStep);
    pose = Advance(pose, command.velocity, kStep);
  }
  EXPECT_TRUE(command.obstacle);
  EXPECT_EQ(command.velocity.linear, 0);
  EXPECT_LT(pose.x, 3 - 0.33 - 0.05);
  EXPECT_GT(pose.x, 2.3);
}

TEST(Follower, NeverComesNearerInTimeThanItsLimit) {
  Follower follower;
  follower.SetPath(Line({0, 0}, {5, 0}), 0);
  Pose2D pose{0, 0, 0};
  for (int i = 0; i < 400; ++i) {
    const auto command = follower.Update(pose, {RelativeTo(pose, Point2D{3, 0})}, kStep);
    pose = Advance(pose, command.velocity, kStep);
    const double gap = 3 - 0.33 - pose.x;
    EXPECT_LE(command.velocity.linear, gap / 0.9);
  }
}

TEST(Follower, GoesSlowlyNearObstaclesAtTheSide) {
  Follower follower;
  follower.SetPath(Line({0, 0}, {9, 0}), 0);
  double speed = 0;
  for (int i = 0; i < 60; ++i) speed = follower.Update({}, {{0.3, 0.5}}, kStep).velocity.linear;
  EXPECT_NEAR(speed, 0.7 * (std::hypot(0.3, 0.5) - 0.33) / 0.6, 0.01);
}

TEST(Follower, KeepsItsSpeedWhenThePathIsReplaced) {
  Follower follower;
  follower.SetPath(Line({0, 0}, {9, 0}), 0);
  double speed = 0;
  for (int i = 0; i < 60; ++i) speed = follower.Update({}, {}, kStep).velocity.linear;
  follower.SetPath(Line({0, 0}, {9, 0.1}), 0);
  EXPECT_NEAR(follower.Update({}, {}, kStep).velocity.linear, speed, 0.02);
}

TEST(Follower, BrakesWithoutAPath) {
  Follower follower;
  follower.SetPath(Line({0, 0}, {9, 0}), 0);
  for (int i = 0; i < 60; ++i) follower.Update({}, {}, kStep);
  follower.ClearPath();
  double speed = 1;
  for (int i = 0; i < 30; ++i) {
    const double next = follower.Update({}, {}, kStep).velocity.linear;
    EXPECT_LE(next, speed);
    speed = next;
  }
  EXPECT_EQ(speed, 0);
}

}  // namespace
}  // namespace coppice::robot::navigation
