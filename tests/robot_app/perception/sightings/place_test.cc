#include "robot_app/perception/sightings/place.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::robot::perception {
namespace {

constexpr int kWidth = 100, kHeight = 80;

// A camera that looks along x, its lens at (1, 2).
Ranges LookingAlongX() {
  Ranges ranges;
  ranges.lens = {100, 100, 50, 40};
  Eigen::Matrix3d axes;  // x right, y down, z forward
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  ranges.optical_in_frame.linear() = axes;
  ranges.optical_in_frame.translation() = Eigen::Vector3d(1, 2, 1.3);
  return ranges;
}

Ranges WithDepth(std::uint16_t millimetres) {
  Ranges ranges = LookingAlongX();
  ranges.depth = DepthPicture(kWidth, kHeight);
  for (std::uint16_t& depth : ranges.depth.millimetres) depth = millimetres;
  return ranges;
}

Sighting PersonAt(double x) { return {SightingKind::kPerson, {x - 10, 10, 20, 60}, 0.9}; }

TEST(PlaceOf, PutsSomebodyAheadAsFarAsTheDepthSays) {
  const auto place = PlaceOf(PersonAt(50), WithDepth(3000));
  ASSERT_TRUE(place);
  EXPECT_EQ(place->by, RangedBy::kDepth);
  EXPECT_NEAR(place->position.x(), 1 + 3.1, 0.01) << "the axis is behind the surface";
  EXPECT_NEAR(place->position.y(), 2, 0.01);
}

TEST(PlaceOf, PutsSomebodyOnTheRightToTheRight) {
  const auto place = PlaceOf(PersonAt(80), WithDepth(3000));
  ASSERT_TRUE(place);
  EXPECT_LT(place->position.y(), 2 - 0.8);
}

TEST(PlaceOf, TakesTheMedianSoThatTheWallBehindDoesNotCount) {
  Ranges ranges = WithDepth(2000);
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < 48; ++column)
      ranges.depth.millimetres[kWidth * row + column] = 4900;
  }
  const auto place = PlaceOf(PersonAt(50), ranges);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->position.x(), 1 + 2.1, 0.01);
}

TEST(PlaceOf, TakesTheLidarForWhatIsTooFarForDepth) {
  Ranges ranges = WithDepth(8000);
  for (int i = 0; i < 5; ++i) ranges.lidar.emplace_back(0, 0.1F * static_cast<float>(i), 8);
  const auto place = PlaceOf(PersonAt(50), ranges);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->by, RangedBy::kLidar);
  EXPECT_NEAR(place->position.x(), 1 + 8.1, 0.01);
}

TEST(PlaceOf, KnowsNothingWithoutEnoughPoints) {
  Ranges ranges = LookingAlongX();
  EXPECT_FALSE(PlaceOf(PersonAt(50), ranges));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 9; ++i) ranges.lidar.emplace_back(nan, nan, nan);
  ranges.lidar.emplace_back(0, 0, -3);
  EXPECT_FALSE(PlaceOf(PersonAt(50), ranges));
  EXPECT_FALSE(PlaceOf({SightingKind::kFace, {500, 500, 10, 10}, 1}, WithDepth(2000)));
}

TEST(PlaceOf, IsLessSureOfWhatIsFar) {
  EXPECT_LT(PlaceOf(PersonAt(50), WithDepth(1000))->covariance.trace(),
            PlaceOf(PersonAt(50), WithDepth(4000))->covariance.trace());
}

}  // namespace
}  // namespace coppice::robot::perception
