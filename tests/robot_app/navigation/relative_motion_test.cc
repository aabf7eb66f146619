#include "robot_app/navigation/relative_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coppice::robot::navigation {
namespace {

using State = RelativeMotion::State;
using testing::HasSubstr;

constexpr double kStep = 0.05;

// Updates until the motion has ended; `share` of the commanded motion really happens.
double Carry(RelativeMotion& motion, Pose2D& pose, std::vector<Point2D> obstacles = {},
             double share = 1) {
  double seconds = 0;
  const std::vector<Point2D> fixed = obstacles;
  const Pose2D start = pose;
  for (; motion.state() == State::kMoving && seconds < 100; seconds += kStep) {
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      obstacles[i] = RelativeTo(pose, Compose(start, fixed[i]));
    }
    const Velocity2D velocity = motion.Update(pose, obstacles, kStep);
    pose = Advance(pose, {share * velocity.linear, share * velocity.angular}, kStep);
  }
  return seconds;
}

TEST(RelativeMotion, DrivesTheDistanceThenTurns) {
  RelativeMotion motion;
  Pose2D pose{3, 2, 1};
  motion.Start(pose, 0.8, -M_PI / 2, 0.2);
  Carry(motion, pose);
  EXPECT_EQ(motion.state(), State::kDone);
  EXPECT_NEAR(pose.x, 3 + 0.8 * std::cos(1), 0.02);
  EXPECT_NEAR(pose.y, 2 + 0.8 * std::sin(1), 0.02);
  EXPECT_NEAR(NormalizeAngle(pose.yaw - 1 + M_PI / 2), 0, 0.03);
}

TEST(RelativeMotion, BacksUp) {
  RelativeMotion motion;
  Pose2D pose;
  motion.Start(pose, -0.5, 0, 0.1);
  const double seconds = Carry(motion, pose);
  EXPECT_EQ(motion.state(), State::kDone);
  EXPECT_NEAR(pose.x, -0.5, 0.02);
  EXPECT_NEAR(seconds, 5.5, 1.5);
}

TEST(RelativeMotion, EndsWhereTheOdometryJumpsOrIsNoNumber) {
  for (const Pose2D& nowhere : {Pose2D{NAN, 0, 0}, Pose2D{0, 0, NAN}, Pose2D{1e300, 0, 0}}) {
    RelativeMotion motion;
    motion.Start({}, -0.5, 0, 0.1, {0.2, 0});
    motion.Update({}, {}, kStep);
    EXPECT_EQ(motion.Update(nowhere, {}, kStep).linear, 0);
    EXPECT_EQ(motion.state(), State::kFailed);
    EXPECT_EQ(motion.message(), "the odometry jumps");
    motion.Start(nowhere, -0.5, 0, 0.1);
    Pose2D pose;
    EXPECT_LT(Carry(motion, pose), 10);
    EXPECT_GT(pose.x, -1);
  }
}

TEST(RelativeMotion, TurnsMoreThanAFullCircle) {
  RelativeMotion motion;
  Pose2D pose;
  motion.Start(pose, 0, 7.5, 0.8);
  const double seconds = Carry(motion, pose);
  EXPECT_EQ(motion.state(), State::kDone);
  EXPECT_NEAR(NormalizeAngle(pose.yaw - 7.5), 0, 0.03);
  EXPECT_GT(seconds, 7.4 / 0.8);
}

TEST(RelativeMotion, FirstStopsARobotThatIsMoving) {
  RelativeMotion motion;
  Pose2D pose;
  motion.Start(pose, -0.5, 0, 0.2, {0.6, 0.3});
  double farthest = 0;
  double last = 0.6;
  while (motion.state() == State::kMoving) {
    const Velocity2D velocity = motion.Update(pose, {}, kStep);
    if (last > 0) {
      EXPECT_NEAR(velocity.linear, last, 0.6 * kStep + 1e-9);
    }
    last = velocity.linear;
    pose = Advance(pose, velocity, kStep);
    farthest = std::max(farthest, pose.x);
  }
  EXPECT_EQ(motion.state(), State::kDone) << motion.message();
  EXPECT_NEAR(farthest, 0.3, 0.06) << "the braking distance";
  EXPECT_NEAR(pose.x, farthest - 0.5, 0.05);
}

TEST(RelativeMotion, RefusesToGoFarBackwards) {
  RelativeMotion motion;
  motion.Start({}, -1.2, 0, 0);
  EXPECT_EQ(motion.state(), State::kFailed);
  EXPECT_THAT(motion.message(), HasSubstr("at most 1.00 m"));
}

TEST(RelativeMotion, RefusesWhatIsNoNumber) {
  RelativeMotion motion;
  motion.Start({}, NAN, 0, 0);
  EXPECT_EQ(motion.state(), State::kFailed);
  motion.Start({}, 1, 0, -0.1);
  EXPECT_EQ(motion.state(), State::kFailed);
}

TEST(RelativeMotion, StopsBeforeAnObstacleAndGivesUpAfterAWhile) {
  RelativeMotion motion;
  Pose2D pose;
  motion.Start(pose, 2, 0, 0.3);
  Carry(motion, pose, {{1.5, 0}});
  EXPECT_EQ(motion.state(), State::kFailed);
  EXPECT_THAT(motion.message(), HasSubstr("obstacle"));
  EXPECT_LT(pose.x, 1.5 - 0.33 - 0.05);
  EXPECT_GT(pose.x, 0.8);
}

TEST(RelativeMotion, NoticesThatTheWheelsDoNotMoveIt) {
  RelativeMotion motion;
  Pose2D pose;
  motion.Start(pose, -0.5, 0, 0.1);
  const double seconds = Carry(motion, pose, {}, 0.05);
  EXPECT_EQ(motion.state(), State::kFailed);
  EXPECT_THAT(motion.message(), HasSubstr("do not move"));
  EXPECT_LT(seconds, 3);
}

}  // namespace
}  // namespace coppice::robot::navigation
