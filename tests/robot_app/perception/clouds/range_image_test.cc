#include "robot_app/perception/clouds/range_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace coppice::robot::perception {
namespace {

RangeImage Fill(const std::vector<LidarPoint>& points) {
  RangeImage image;
  FillRangeImage(points, {}, image);
  return image;
}

TEST(RangeImage, APointAheadLiesInTheMiddleColumnAtItsHeightAboveTheFloor) {
  const RangeImage image = Fill({{3, 0, 0.1F, 20, 8}});
  const std::size_t cell = image.cell(8, 450);
  EXPECT_NEAR(image.ranges[cell], std::hypot(3, 0.1), 1e-5);
  EXPECT_NEAR(image.points[cell].z(), 1.3, 1e-5);
  EXPECT_EQ(image.intensities[cell], 20);
}

TEST(RangeImage, TheNearerOfTwoPointsInACellStays) {
  const RangeImage image = Fill({{3, 0, 0, 0, 8}, {2, 0, 0, 0, 8}, {4, 0, 0, 0, 8}});
  EXPECT_NEAR(image.ranges[image.cell(8, 450)], 2, 1e-5);
}

TEST(RangeImage, ColumnsGoRound) {
  const RangeImage image = Fill({});
  EXPECT_EQ(image.cell(3, -1), image.cell(3, 899));
  EXPECT_EQ(image.cell(3, 900), image.cell(3, 0));
}

TEST(RangeImage, WhatIsNoMeasurementIsLeftOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  RangeImage image;
  EXPECT_EQ(FillRangeImage({{nan, nan, nan, 0, 0},
                            {infinity, 0, 0, 0, 0},
                            {0.1F, 0, 0, 0, 0},
                            {3, 0, 0, 0, 16},
                            {3, 0, 0, 0, 65535}},
                           {}, image),
            0U);
}

TEST(RangeImage, APictureUsedAgainForgetsTheTurnBefore) {
  RangeImage image;
  FillRangeImage({{3, 0, 0, 0, 8}}, {}, image);
  FillRangeImage({}, {}, image);
  EXPECT_EQ(image.ranges[image.cell(8, 450)], 0);
}

TEST(RangeImage, AnyNumbersAtAllFindACellOrNone) {
  std::mt19937 random(1);
  std::vector<LidarPoint> points;
  for (int i = 0; i < 20000; ++i) {
    LidarPoint point;
    for (float* value : {&point.x, &point.y, &point.z}) {
      const std::uint32_t bits = random();
      std::memcpy(value, &bits, sizeof(bits));
    }
    point.ring = static_cast<std::uint16_t>(random());
    points.push_back(point);
  }
  RangeImage image;
  const std::size_t kept = FillRangeImage(points, {}, image);
  EXPECT_LE(kept, image.size());
}

}  // namespace
}  // namespace coppice::robot::perception
