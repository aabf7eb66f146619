#include "editor/canvas/layout/packed_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "editor/canvas/layout/wrapped_tree.h"

namespace coppice::editor {
namespace {

struct Shape {
  std::vector<std::uint32_t> ends;
  std::vector<Point> sizes;
};

// Any tree with boxes of any size.
Shape AnyTree(unsigned seed, std::uint32_t count) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> parents(count, 0);
  std::vector<std::uint32_t> branch = {0};  // to the node before
  for (std::uint32_t i = 1; i < count; ++i) {
    branch.resize(1 + random() % std::min<std::size_t>(branch.size(), 12));
    parents[i] = branch.back();
    branch.push_back(i);
  }
  Shape tree;
  tree.ends.resize(count);
  for (std::uint32_t i = count; i-- > 0;) {
    tree.ends[i] = std::max(tree.ends[i], i + 1);
    if (i > 0) tree.ends[parents[i]] = std::max(tree.ends[parents[i]], tree.ends[i]);
    tree.sizes.push_back(
        {40.0F + static_cast<float>(random() % 160), 26.0F + static_cast<float>(random() % 30)});
  }
  return tree;
}

RowOptions Within(float limit, bool packed) {
  RowOptions options;
  options.limit = options.breadth = limit;
  options.packed = packed;
  return options;
}

TEST(PackedRows, KeepTheirDistancesAndTheOrderOfReading) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Shape tree = AnyTree(seed, 60);
    const std::vector<Box> boxes = LayOutWrapped(tree.ends, tree.sizes, Within(1200, true)).boxes;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      std::uint32_t before = 0;  // the sibling
      for (std::uint32_t c = i + 1; c < tree.ends[i]; c = tree.ends[c]) {
        EXPECT_GE(boxes[c].min.x, boxes[i].min.x + 33.9F) << seed;
        EXPECT_GE(boxes[c].min.y, boxes[i].max.y + 37.9F) << seed;
        const bool is_right = before > 0 && boxes[c].min.y == boxes[before].min.y &&
                              boxes[c].min.x >= boxes[before].max.x + 17.9F;
        const bool is_below = before > 0 && boxes[c].min.y >= boxes[before].max.y + 37.9F;
        EXPECT_TRUE(before == 0 || is_right || is_below) << seed;
        before = c;
      }
      for (std::uint32_t other = i + 1; other < boxes.size(); ++other) {
        const bool apart =
            boxes[i].max.x <= boxes[other].min.x || boxes[other].max.x <= boxes[i].min.x ||
            boxes[i].max.y <= boxes[other].min.y || boxes[other].max.y <= boxes[i].min.y;
        EXPECT_TRUE(apart) << seed << ": " << i << " and " << other;
      }
    }
  }
}

TEST(PackedRows, AreNotLongerThanTheLimit) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Shape tree = AnyTree(seed, 60);
    EXPECT_LE(LayOutWrapped(tree.ends, tree.sizes, Within(1200, true)).bounds.width(), 1200.1F);
  }
}

TEST(PackedRows, TakeLessRoomThanRowsThatAreBrokenWhereTheyAreTooLong) {
  float packed = 0;
  float broken = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Shape tree = AnyTree(seed, 60);
    packed += LayOutWrapped(tree.ends, tree.sizes, Within(1200, true)).bounds.height();
    broken += LayOutWrapped(tree.ends, tree.sizes, Within(1200, false)).bounds.height();
  }
  EXPECT_LT(packed, 0.9F * broken);
}

TEST(PackedRows, OfANodeThatIsBroaderThanTheLimitStandBelowIt) {
  const Shape tree = {{3, 2, 3}, {{900, 30}, {700, 30}, {800, 30}}};
  const std::vector<Box> boxes = LayOutWrapped(tree.ends, tree.sizes, Within(300, true)).boxes;
  EXPECT_LT(boxes[1].max.y, boxes[2].min.y);
}

TEST(PackedRows, OfALongRowAreFoundInTime) {
  Shape row = {{300}, {{100, 30}}};
  for (std::uint32_t i = 1; i < 300; ++i) {
    row.ends.push_back(i + 1);
    row.sizes.push_back({100, 30});
  }
  const Box bounds = LayOutWrapped(row.ends, row.sizes, Within(1200, true)).bounds;
  EXPECT_NEAR(bounds.height(), 30 + 30 * 68, 1) << "ten in each row";
}

}  // namespace
}  // namespace coppice::editor
