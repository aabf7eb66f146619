#include "editor/canvas/layout/tidy_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace coppice::editor {
namespace {

struct RandomTree {
  std::vector<std::uint32_t> ends;
  std::vector<std::uint32_t> parents;
  std::vector<Point> sizes;
};

// Each new node hangs below one of the last branch, so deep and broad trees both come up.
RandomTree MakeTree(std::uint32_t count, unsigned seed) {
  std::mt19937 random(seed);
  RandomTree tree;
  std::vector<std::uint32_t> branch;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i > 0) branch.resize(1 + random() % branch.size());
    tree.parents.push_back(i == 0 ? 0 : branch.back());
    branch.push_back(i);
    tree.ends.push_back(i + 1);
    tree.sizes.push_back(
        {20.0F + static_cast<float>(random() % 200), 10.0F + static_cast<float>(random() % 120)});
  }
  for (std::uint32_t i = count; i-- > 1;) {
    tree.ends[tree.parents[i]] = std::max(tree.ends[tree.parents[i]], tree.ends[i]);
  }
  return tree;
}

int Overlaps(const std::vector<Box>& boxes) {
  int count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) count += boxes[i].Overlaps(boxes[j]);
  }
  return count;
}

TEST(TidyTree, NeverLetsBoxesOverlap) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const RandomTree tree = MakeTree(5 + seed * 5, seed);
    for (const Orientation way : {Orientation::kTopToBottom, Orientation::kLeftToRight}) {
      EXPECT_EQ(Overlaps(LayOut(tree.ends, tree.sizes, {way, 10, 20}).boxes), 0) << seed;
    }
  }
}

TEST(TidyTree, PutsParentsOverTheMiddleOfFirstAndLastChild) {
  const RandomTree tree = MakeTree(300, 7);
  const std::vector<Box> boxes = LayOut(tree.ends, tree.sizes, {}).boxes;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (tree.ends[i] == i + 1) continue;
    std::uint32_t last = i + 1;
    while (tree.ends[last] < tree.ends[i]) last = tree.ends[last];
    // Rounding of the sums along deep branches is all that is allowed.
    const float middle = (boxes[i + 1].center().x + boxes[last].center().x) / 2;
    EXPECT_NEAR(boxes[i].center().x, middle, 0.1F) << i;
  }
}

TEST(TidyTree, KeepsTheOrderOfSiblings) {
  const RandomTree tree = MakeTree(400, 3);
  const std::vector<Box> boxes = LayOut(tree.ends, tree.sizes, {}).boxes;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t c = i + 1; c < tree.ends[i] && tree.ends[c] < tree.ends[i];
         c = tree.ends[c]) {
      EXPECT_LT(boxes[c].max.x, boxes[tree.ends[c]].min.x);
    }
  }
}

TEST(TidyTree, HangsEachChildOneGapBelowItsParent) {
  const RandomTree tree = MakeTree(200, 5);
  const std::vector<Box> boxes =
      LayOut(tree.ends, tree.sizes, {Orientation::kTopToBottom, 10, 30}).boxes;
  for (std::uint32_t i = 1; i < boxes.size(); ++i) {
    EXPECT_NEAR(boxes[i].min.y, boxes[tree.parents[i]].max.y + 30, 0.01F);
  }
}

TEST(TidyTree, GrowsToTheRightWhenLeftToRight) {
  const TidyTree tree =
      LayOut({3, 2, 3}, {{50, 20}, {60, 20}, {40, 30}}, {Orientation::kLeftToRight, 10, 25});
  EXPECT_EQ(tree.boxes[1].min.x, 75);
  EXPECT_EQ(tree.boxes[2].min.x, 75);
  EXPECT_EQ(tree.boxes[2].min.y, tree.boxes[1].max.y + 10);
  EXPECT_EQ(tree.boxes[0].center().y, (tree.boxes[1].center().y + tree.boxes[2].center().y) / 2);
}

TEST(TidyTree, SpreadsSmallSubtreesBetweenLargeOnes) {
  // Two broad branches with a leaf between them: the leaf stands in the middle of the gap.
  const std::vector<std::uint32_t> ends = {8, 4, 3, 4, 5, 8, 7, 8};
  std::vector<Point> sizes(8, {20, 10});
  sizes[2] = sizes[3] = sizes[6] = sizes[7] = {200, 10};
  const std::vector<Box> boxes = LayOut(ends, sizes, {}).boxes;
  const float left = boxes[4].min.x - boxes[1].max.x;
  const float right = boxes[5].min.x - boxes[4].max.x;
  EXPECT_NEAR(left, right, 0.5F);
  EXPECT_GT(left, 100);
}

TEST(TidyTree, TakesLinearTime) {
  const auto steps_per_node = [](std::uint32_t count) {
    const RandomTree tree = MakeTree(count, 11);
    return static_cast<double>(LayOut(tree.ends, tree.sizes, {}).steps) / count;
  };
  EXPECT_LT(steps_per_node(1000), 6);
  EXPECT_LT(steps_per_node(30000), 6);
}

TEST(TidyTree, TakesLinearTimeForManySiblingsAndLongChains) {
  std::vector<std::uint32_t> star = {20000};
  std::vector<std::uint32_t> chain;
  for (std::uint32_t i = 1; i < 20000; ++i) star.push_back(i + 1);
  for (std::uint32_t i = 0; i < 20000; ++i) chain.push_back(20000);
  const std::vector<Point> sizes(20000, {10, 10});
  EXPECT_LT(LayOut(star, sizes, {}).steps, 6 * 20000U);
  EXPECT_LT(LayOut(chain, sizes, {}).steps, 6 * 20000U);
}

TEST(TidyTree, AcceptsAnEmptyTree) { EXPECT_TRUE(LayOut({}, {}, {}).boxes.empty()); }

}  // namespace
}  // namespace coppice::editor
