#include "robot_app/slam/straightened_cloud.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/slam/graph/floor_pose.h"

namespace coppice::robot::slam {
namespace {

constexpr double kStamp = 10;
constexpr double kTurnRate = 0.8;  // rad/s
constexpr double kSpeed = 0.5;     // m/s

Pose2D RobotAt(double stamp) {
  const double gone = stamp - kStamp;
  return {kSpeed * gone, 0.2, kTurnRate * gone};
}

// A wall in front of a robot that turns and drives: seen by a lidar in a tenth of a second.
class StraightenedTest : public testing::Test {
 protected:
  StraightenedTest() {
    lidar_.translation() << 0.1, 0, 1.2;
    for (double t = 9.9; t < 10.2; t += 0.02) odometry_.Add(t, RobotAt(t));
    for (int i = 0; i < 100; ++i) {
      const float time = 0.001F * static_cast<float>(i);
      wall_.emplace_back(4, -2 + 0.04 * i, 0.5);
      const Pose3 seen_from = ToPose3(RobotAt(kStamp + time)) * lidar_;
      const Eigen::Vector3f seen =
          (seen_from.inverse() * ToPose3(RobotAt(kStamp)) * wall_.back()).cast<float>();
      points_.push_back({seen.x(), seen.y(), seen.z(), 0, 7, time});
    }
  }
  double FarthestOff(const CloudPoints& cloud) const {
    double farthest = 0;
    for (std::size_t i = 0; i < wall_.size(); ++i) {
      farthest = std::max(farthest, (cloud[i].cast<double>() - wall_[i]).norm());
    }
    return farthest;
  }

  Pose3 lidar_ = Pose3::Identity();
  localization::PoseHistory odometry_;
  std::vector<Eigen::Vector3d> wall_;  // in base_link at the stamp
  std::vector<perception::LidarPoint> points_;
};

TEST_F(StraightenedTest, AWallIsStraightAgainAlthoughTheRobotTurned) {
  const CloudPoints cloud = Straightened(points_, lidar_, kStamp, odometry_);
  ASSERT_EQ(cloud.size(), wall_.size());
  EXPECT_LT(FarthestOff(cloud), 0.01);
}

TEST_F(StraightenedTest, PointsOfATimeThatNobodyKnowsOfStayAsTheyWereMeasured) {
  for (perception::LidarPoint& point : points_) point.time += 100;
  const CloudPoints cloud = Straightened(points_, lidar_, kStamp, odometry_);
  ASSERT_EQ(cloud.size(), wall_.size());
  EXPECT_GT(FarthestOff(cloud), 0.2);
}

TEST_F(StraightenedTest, WhatMetNothingIsLeftOut) {
  points_[3].x = std::nanf("");
  EXPECT_EQ(Straightened(points_, lidar_, kStamp, odometry_).size(), wall_.size() - 1);
}

}  // namespace
}  // namespace coppice::robot::slam
