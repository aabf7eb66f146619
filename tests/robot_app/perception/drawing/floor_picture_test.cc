#include "robot_app/perception/drawing/floor_picture.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::robot::perception {
namespace {

constexpr Colour kWhite{255, 255, 255};

TEST(FloorPicture, XGoesToTheRightAndYUp) {
  FloorPicture picture({1, 1}, 5, 200);  // 20 pixels a metre
  picture.DrawPoints({{4, 3}}, ColourOf(0));
  EXPECT_EQ(picture.picture().at(100 + 60, 100 - 40), ColourOf(0));
  EXPECT_EQ(picture.picture().at(100 - 60, 100 - 40), kWhite);
}

TEST(FloorPicture, WhatIsOutsideOrNowhereIsLeftOut) {
  FloorPicture picture({0, 0}, 5, 200);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  picture.DrawPerson({1e300, -1e300}, {nan, 1}, "1", ColourOf(1));
  picture.DrawTrail({{-1e9, 0}, {-2e9, nan}}, ColourOf(1));
  EXPECT_EQ(picture.picture().at(50, 150), kWhite);
}

TEST(FloorPicture, WhoFollowsEachOtherHasAnotherColour) {
  for (std::uint32_t i = 0; i < 9; ++i) EXPECT_NE(ColourOf(i), ColourOf(i + 1)) << i;
}

}  // namespace
}  // namespace coppice::robot::perception
