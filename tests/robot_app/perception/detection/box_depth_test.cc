#include "robot_app/perception/detection/box_depth.h"

#include <gtest/gtest.h>

namespace coppice::robot::perception {
namespace {

DepthPicture Wall(std::uint16_t millimetres) {
  DepthPicture depth(100, 80);
  for (std::uint16_t& value : depth.millimetres) value = millimetres;
  return depth;
}

TEST(MedianDepth, IsThatOfMostPixelsInTheMiddleOfTheBox) {
  DepthPicture depth = Wall(5000);
  for (int row = 20; row < 60; ++row) {
    for (int column = 30; column < 50; ++column) depth.millimetres[100 * row + column] = 2000;
  }
  EXPECT_DOUBLE_EQ(MedianDepth(depth, {28, 18, 24, 44}), 2);
  EXPECT_DOUBLE_EQ(MedianDepth(depth, {60, 0, 40, 80}), 5);
}

TEST(MedianDepth, LeavesOutWhatIsNotMeasured) {
  DepthPicture depth = Wall(0);
  EXPECT_DOUBLE_EQ(MedianDepth(depth, {0, 0, 100, 80}), 0);
  depth.millimetres[100 * 40 + 50] = 3000;
  EXPECT_DOUBLE_EQ(MedianDepth(depth, {0, 0, 100, 80}), 3);
}

TEST(MedianDepth, OfABoxBeyondThePictureIsThatOfItsPartInside) {
  EXPECT_DOUBLE_EQ(MedianDepth(Wall(4000), {-50, -50, 200, 200}), 4);
  EXPECT_DOUBLE_EQ(MedianDepth(Wall(4000), {500, 10, 20, 20}), 0);
  EXPECT_DOUBLE_EQ(MedianDepth({}, {0, 0, 10, 10}), 0);
}

TEST(HasDepth, NeedsALensAndThePictureOfTheColours) {
  const Picture picture(100, 80);
  const DepthPicture depth = Wall(1000), other(50, 40);
  EXPECT_TRUE(HasDepth({picture, &depth, 600}));
  EXPECT_FALSE(HasDepth({picture, &depth, 0}));
  EXPECT_FALSE(HasDepth({picture, &other, 600}));
  EXPECT_FALSE(HasDepth(picture));
}

}  // namespace
}  // namespace coppice::robot::perception
