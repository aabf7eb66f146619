#include "editor/canvas/layout/wrapped_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::editor {
namespace {

struct Shape {
  std::vector<std::uint32_t> ends;
  std::vector<Point> sizes;
};

// Every node has so many children, down to that depth.
void AddBranch(Shape& tree, int children, int depth) {
  const std::size_t self = tree.ends.size();
  tree.ends.push_back(0);
  tree.sizes.push_back({140, 40});
  for (int i = 0; depth > 0 && i < children; ++i) AddBranch(tree, children, depth - 1);
  tree.ends[self] = static_cast<std::uint32_t>(tree.ends.size());
}

Shape Tree(int children, int depth) {
  Shape tree;
  AddBranch(tree, children, depth);
  return tree;
}

RowOptions Across() {
  RowOptions options;
  options.orientation = Orientation::kLeftToRight;
  return options;
}

TEST(WrappedTree, IsNeverAThinLine) {
  for (const auto& [children, depth] : {std::pair(4, 5), std::pair(400, 1), std::pair(30, 2)}) {
    const Shape tree = Tree(children, depth);
    const Box tidy = LayOut(tree.ends, tree.sizes, {}).bounds;
    ASSERT_GT(tidy.width(), 20 * tidy.height()) << children;
    const Box down = LayOutWrapped(tree.ends, tree.sizes, {}).bounds;
    EXPECT_LT(down.width(), 3.3F * down.height()) << children;
    EXPECT_LT(down.height(), 2 * down.width()) << children;
    const Box across = LayOutWrapped(tree.ends, tree.sizes, Across()).bounds;
    EXPECT_LT(across.height(), 3 * across.width()) << children;
    EXPECT_LT(across.width(), 4 * across.height()) << children;
  }
}

TEST(WrappedTree, IsNotLongerThanItsLimit) {
  const Shape tree = Tree(6, 3);
  RowOptions options;
  options.limit = 900;
  EXPECT_LE(LayOutWrapped(tree.ends, tree.sizes, options).bounds.width(), 900.1F);
  options.orientation = Orientation::kLeftToRight;
  EXPECT_LE(LayOutWrapped(tree.ends, tree.sizes, options).bounds.height(), 900.1F);
}

TEST(WrappedTree, LeavesARowThatIsShortEnough) {
  const Shape tree = Tree(3, 1);
  const WrappedTree wrapped = LayOutWrapped(tree.ends, tree.sizes, {});
  EXPECT_EQ(wrapped.boxes[1].min.y, wrapped.boxes[3].min.y);
}

TEST(WrappedTree, NeverLetsBoxesOverlap) {
  const Shape tree = Tree(4, 4);
  for (const RowOptions& options : {RowOptions(), Across()}) {
    const std::vector<Box> boxes = LayOutWrapped(tree.ends, tree.sizes, options).boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        ASSERT_FALSE(boxes[i].Overlaps(boxes[j])) << i << " and " << j;
      }
    }
  }
}

TEST(WrappedTree, ReadsAsAText) {
  const Shape tree = Tree(60, 1);
  const WrappedTree wrapped = LayOutWrapped(tree.ends, tree.sizes, {});
  int rows = 1;
  for (std::size_t i = 2; i < wrapped.boxes.size(); ++i) {
    const Box& before = wrapped.boxes[i - 1];
    const Box& box = wrapped.boxes[i];
    if (box.min.y == before.min.y) {
      EXPECT_GT(box.min.x, before.max.x) << i;
    } else {
      EXPECT_GT(box.min.y, before.max.y) << i;
      EXPECT_EQ(box.min.x, wrapped.boxes[1].min.x) << "every row begins at the left";
      ++rows;
    }
  }
  EXPECT_GT(rows, 3);
}

TEST(WrappedTree, IndentsTheRowsBelowTheirNode) {
  const Shape tree = Tree(60, 1);
  const WrappedTree wrapped = LayOutWrapped(tree.ends, tree.sizes, {});
  EXPECT_EQ(wrapped.boxes[0].min, (Point{0, 0}));
  for (std::size_t i = 1; i < wrapped.boxes.size(); ++i) {
    EXPECT_GT(wrapped.boxes[i].min.x, 20) << i;
  }
}

TEST(WrappedTree, AcceptsAnEmptyTreeAndASingleNode) {
  EXPECT_TRUE(LayOutWrapped({}, {}, {}).boxes.empty());
  const WrappedTree one = LayOutWrapped({1}, {{50, 20}}, {});
  EXPECT_EQ(one.bounds.width(), 50);
  EXPECT_EQ(one.bounds.height(), 20);
}

}  // namespace
}  // namespace coppice::editor
