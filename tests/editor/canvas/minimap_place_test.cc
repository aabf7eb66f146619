#include <gtest/gtest.h>

#include "editor/canvas/minimap.h"

namespace coppice::editor {
namespace {

const Box kCanvas = {{100, 50}, {1100, 650}};
constexpr Point kSize = {180, 100};
constexpr float kMargin = 10;

CornerChoice Choose(const std::vector<Box>& nodes, Corner present = Corner::kUpperRight) {
  return FreestCorner(kCanvas, kSize, kMargin, nodes, present);
}

Box At(Corner corner) { return InCorner(corner, kCanvas, kSize, kMargin); }

TEST(MinimapPlace, IsInsideOfTheCanvas) {
  EXPECT_EQ(At(Corner::kUpperRight), (Box{{910, 60}, {1090, 160}}));
  EXPECT_EQ(At(Corner::kLowerLeft), (Box{{110, 540}, {290, 640}}));
  EXPECT_EQ(At(Corner::kUpperLeft).min, (Point{110, 60}));
  EXPECT_EQ(At(Corner::kLowerRight).max, (Point{1090, 640}));
}

TEST(MinimapPlace, LeavesTheCornerOfANode) {
  const CornerChoice choice = Choose({At(Corner::kUpperRight)});
  EXPECT_EQ(choice.corner, Corner::kLowerRight);
  EXPECT_TRUE(choice.is_free);
}

TEST(MinimapPlace, StaysInACornerThatIsFree) {
  EXPECT_EQ(Choose({}).corner, Corner::kUpperRight);
  EXPECT_EQ(Choose({}, Corner::kLowerLeft).corner, Corner::kLowerLeft);
}

TEST(MinimapPlace, SaysThatNoCornerIsFreeAndNamesTheOneWhereItHidesLeast) {
  Box little = At(Corner::kUpperLeft);
  little.max = little.min + Point{20, 20};
  const CornerChoice choice =
      Choose({At(Corner::kUpperRight), At(Corner::kLowerRight), At(Corner::kLowerLeft), little});
  EXPECT_EQ(choice.corner, Corner::kUpperLeft);
  EXPECT_FALSE(choice.is_free);
}

}  // namespace
}  // namespace coppice::editor
