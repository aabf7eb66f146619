#include "robot_app/perception/clouds/ground.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/robot_app/perception/clouds/painted_image.h"

namespace coppice::robot::perception {
namespace {

std::vector<Surface> Surfaces(const RangeImage& image) {
  std::vector<Surface> surfaces;
  FindGround(image, {}, surfaces);
  return surfaces;
}

std::size_t Count(const std::vector<Surface>& surfaces, Surface kind) {
  return static_cast<std::size_t>(std::count(surfaces.begin(), surfaces.end(), kind));
}

// Of the points of an image those with this surface, lowest and highest [m].
std::pair<float, float> Heights(const RangeImage& image, Surface kind) {
  const std::vector<Surface> surfaces = Surfaces(image);
  std::pair<float, float> heights{1e6F, -1e6F};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i] != kind) continue;
    heights.first = std::min(heights.first, image.points[i].z());
    heights.second = std::max(heights.second, image.points[i].z());
  }
  return heights;
}

TEST(FindGround, AFlatFloorIsFloorAsFarAsItIsSeen) {
  const RangeImage image = PaintedCloud({}).image();
  const auto surfaces = Surfaces(image);
  EXPECT_EQ(Count(surfaces, Surface::kFloor), 8U * 900U);
  EXPECT_EQ(Count(surfaces, Surface::kNothing), 8U * 900U);
}

TEST(FindGround, WhatStandsOnTheFloorIsStandingFromCloseAboveIt) {
  const RangeImage image = PaintedCloud({{6, 0, 0.3, 1.7}}).image();
  const auto [low, high] = Heights(image, Surface::kStanding);
  EXPECT_LT(low, 0.3F);
  EXPECT_GT(high, 1.4F);
}

TEST(FindGround, ALowBenchFarAwayIsNoFloor) {
  const RangeImage image = PaintedCloud({{9, 0, 1, 0.45}}).image();
  EXPECT_GT(Heights(image, Surface::kStanding).second, 0.2F);
  EXPECT_LT(Heights(image, Surface::kFloor).second, 0.2F);
}

TEST(FindGround, WhatIsHigherThanAnybodyIsAbove) {
  const RangeImage image = PaintedCloud({{9, 0, 0.5, 4}}).image();
  EXPECT_GT(Heights(image, Surface::kAbove).first, 2.1F);
  EXPECT_LE(Heights(image, Surface::kStanding).second, 2.1F);
}

TEST(FindGround, ARampForWheelchairsIsFloor) {
  RangeImage image = PaintedCloud({}).image();
  for (auto& point : image.points) {
    const float beyond = point.head<2>().norm() - 4;
    if (beyond > 0) point.z() = 0.06F * beyond;
  }
  EXPECT_EQ(Count(Surfaces(image), Surface::kStanding), 0U);
}

TEST(FindGround, AnEmptyPictureHasNothing) {
  RangeImage image;
  FillRangeImage({}, {}, image);
  EXPECT_EQ(Count(Surfaces(image), Surface::kNothing), image.size());
}

}  // namespace
}  // namespace coppice::robot::perception
