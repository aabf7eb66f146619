#include "robot_app/slam/map/sight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::slam {
namespace {

// Half a metre above the floor, at the front of the robot.
const CameraMount kCamera = LevelCamera({300, 300, 159.5, 119.5}, 0.2, 0, 0, 0.5);

DepthPicture WallAt(double metres) {
  DepthPicture depth(320, 240);
  depth.millimetres.assign(depth.millimetres.size(), static_cast<std::uint16_t>(1000 * metres));
  return depth;
}

TEST(SeePicture, WhatTheCameraMeasuredIsGivenInTheRobotsFrame) {
  const CameraCloud cloud = SeePicture(Picture(320, 240), WallAt(2), kCamera).cloud;
  EXPECT_TRUE(cloud.camera.isApprox(Eigen::Vector3f(0.2F, 0, 0.5F)));
  ASSERT_GT(cloud.points.size(), 500U);
  float left = 0, low = 0;
  for (const Eigen::Vector3f& point : cloud.points) {
    EXPECT_NEAR(point.x(), 2.2, 0.006);
    left = std::max(left, point.y());
    low = std::min(low, point.z());
  }
  EXPECT_NEAR(left, 160.0 / 300 * 2, 0.05);
  EXPECT_NEAR(low, 0.5 - 120.0 / 300 * 2, 0.05);
}

TEST(SeePicture, WhatIsTooFarForItsDepthIsLeftOut) {
  EXPECT_TRUE(SeePicture(Picture(320, 240), WallAt(4.5), kCamera).cloud.points.empty());
  EXPECT_TRUE(SeePicture(Picture(320, 240), WallAt(0), kCamera).cloud.points.empty());
}

TEST(SeePicture, DepthOfAnotherSizeThanThePictureIsNone) {
  EXPECT_TRUE(SeePicture(Picture(640, 480), WallAt(2), kCamera).cloud.points.empty());
}

}  // namespace
}  // namespace coppice::robot::slam
