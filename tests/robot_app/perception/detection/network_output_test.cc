#include "robot_app/perception/detection/network_output.h"

#include <gtest/gtest.h>

#include <limits>

namespace coppice::robot::perception {
namespace {

TEST(FormOf, TellsTheLayoutsByTheirSizes) {
  const auto darknet = FormOf({507, 85}, true);
  ASSERT_TRUE(darknet);
  EXPECT_EQ(darknet->layout, OutputLayout::kDarknet);
  EXPECT_EQ(darknet->classes, 80);
  const auto rows = FormOf({1, 25200, 85}, false);
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->layout, OutputLayout::kRows);
  EXPECT_EQ(rows->classes, 80);
  const auto columns = FormOf({1, 84, 8400}, false);
  ASSERT_TRUE(columns);
  EXPECT_EQ(columns->layout, OutputLayout::kColumns);
  EXPECT_EQ(columns->classes, 80);
}

TEST(FormOf, NamesTheSizesThatItDoesNotKnow) {
  const auto form = FormOf({1, 1000}, false);
  ASSERT_FALSE(form);
  EXPECT_NE(form.problem().find("1 x 1000"), std::string::npos) << form.problem();
  EXPECT_FALSE(FormOf({}, true));
}

TEST(BoxesIn, RowsMultiplyTheClassWithThePresence) {
  const float numbers[] = {10, 20, 4, 8, 0.5F, 0.2F, 0.8F, 1, 1, 1, 1, 0.1F, 1, 1};
  const auto boxes = BoxesIn({{1, 2, 7}, numbers}, {OutputLayout::kRows, 2}, 0.3);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_EQ(boxes[0].kind, 1);
  EXPECT_FLOAT_EQ(boxes[0].confidence, 0.4F);
  EXPECT_FLOAT_EQ(boxes[0].height, 8);
}

TEST(BoxesIn, ColumnsAreReadDownwards) {
  const float numbers[] = {1, 10, 2, 20, 3, 30, 4, 40, 0.9F, 0.1F, 0.2F, 0.7F};
  const auto boxes = BoxesIn({{1, 6, 2}, numbers}, {OutputLayout::kColumns, 2}, 0.5);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_FLOAT_EQ(boxes[0].width, 3);
  EXPECT_EQ(boxes[0].kind, 0);
  EXPECT_FLOAT_EQ(boxes[1].x, 10);
  EXPECT_EQ(boxes[1].kind, 1);
}

TEST(BoxesIn, DarknetHasMultipliedAlready) {
  const float numbers[] = {0.5F, 0.5F, 0.1F, 0.2F, 0.5F, 0.45F};
  const auto boxes = BoxesIn({{1, 6}, numbers}, {OutputLayout::kDarknet, 1}, 0.4);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_FLOAT_EQ(boxes[0].confidence, 0.45F);
}

TEST(BoxesIn, LeavesOutWhatIsNoNumberOrHasNoSize) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float numbers[] = {nan, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, nan};
  EXPECT_TRUE(BoxesIn({{1, 3, 6}, numbers}, {OutputLayout::kRows, 1}, 0.1).empty());
}

}  // namespace
}  // namespace coppice::robot::perception
