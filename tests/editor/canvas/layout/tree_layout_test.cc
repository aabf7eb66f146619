#include "editor/canvas/layout/tree_layout.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

namespace coppice::editor {
namespace {

struct RandomTree : MeasuredTree {
  std::vector<std::uint32_t> parents;
};

// Every node hangs on one of the last branch; now and then many leaves follow each other.
RandomTree MakeTree(std::uint32_t count, unsigned seed) {
  std::mt19937 random(seed);
  RandomTree tree;
  std::vector<std::uint32_t> branch;
  std::uint32_t leaves = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i > 0 && leaves == 0) branch.resize(1 + random() % branch.size());
    if (leaves > 0) branch.pop_back();
    leaves = leaves > 0 ? leaves - 1 : random() % 20 == 0 ? 12U : 0U;
    tree.parents.push_back(branch.empty() ? 0 : branch.back());
    branch.push_back(i);
    tree.ends.push_back(i + 1);
    tree.sizes.emplace_back(Point{20.0F + static_cast<float>(random() % 200),
                                  10.0F + static_cast<float>(random() % 120)});
    tree.is_decorator.push_back(random() % 3 == 0);
  }
  for (std::uint32_t i = count; i-- > 1;) {
    tree.ends[tree.parents[i]] = std::max(tree.ends[tree.parents[i]], tree.ends[i]);
  }
  return tree;
}

struct Way {
  LayoutStyle style;
  LayoutChoice choice;
};

std::vector<Way> AllWays() {
  std::vector<Way> ways;
  for (int bits = 0; bits < 64; ++bits) {
    Way way;
    if (bits & 1) way.choice.orientation = Orientation::kLeftToRight;
    way.choice.names_only = (bits & 2) != 0;
    if (bits & 4) way.choice.rows = 700;
    way.style.layered = (bits & 8) != 0;
    way.style.compact = (bits & 16) != 0;
    way.style.stacked = (bits & 32) != 0;
    ways.push_back(way);
  }
  return ways;
}

// Nodes of one size, none of them a decorator.
MeasuredTree Plain(std::vector<std::uint32_t> ends, Point size) {
  MeasuredTree tree;
  tree.sizes.assign(ends.size(), size);
  tree.is_decorator.assign(ends.size(), false);
  tree.ends = std::move(ends);
  return tree;
}

TEST(TreeLayout, NeverLetsBoxesOverlapInAnyStyle) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const RandomTree tree = MakeTree(20 + seed * 15, seed);
    for (const Way& way : AllWays()) {
      const auto boxes = Arrange(tree, way.style, way.choice).boxes;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
          ASSERT_FALSE(boxes[i].Overlaps(boxes[j])) << seed << ": " << i << " and " << j;
        }
      }
    }
  }
}

TEST(TreeLayout, KeepsTheOrderOfSiblingsInAnyStyle) {
  const RandomTree tree = MakeTree(400, 3);
  for (const Way& way : AllWays()) {
    const TreeLayout layout = Arrange(tree, way.style, way.choice);
    for (std::uint32_t i = 0; i < tree.ends.size(); ++i) {
      for (std::uint32_t c = i + 1; c < tree.ends[i] && tree.ends[c] < tree.ends[i];
           c = tree.ends[c]) {
        const Box& a = layout.boxes[c];
        const Box& b = layout.boxes[tree.ends[c]];
        const Link link = layout.links[tree.ends[c]];
        const bool down = way.choice.orientation == Orientation::kTopToBottom;
        const bool right_of = a.max.x <= b.min.x;
        const bool below = a.max.y <= b.min.y;
        if (link == Link::kRow) {
          EXPECT_TRUE(right_of || below) << c;  // or in the next row
        } else if (layout.links[c] == Link::kTrunk && link == Link::kTrunk) {
          EXPECT_TRUE(below || right_of) << c;  // or in the next column
        } else {
          EXPECT_TRUE(down ? right_of : below) << c;
        }
      }
    }
  }
}

TEST(TreeLayout, PutsAllOfADepthOnOneLineWhenLayered) {
  const RandomTree tree = MakeTree(300, 5);
  LayoutStyle style;
  style.layered = true;
  const TreeLayout layout = Arrange(tree, style, {});
  std::vector<std::uint32_t> depth(tree.ends.size(), 0);
  std::vector<float> line(tree.ends.size(), -1);
  for (std::uint32_t i = 0; i < tree.ends.size(); ++i) {
    if (i > 0) depth[i] = depth[tree.parents[i]] + 1;
    if (line[depth[i]] < 0) line[depth[i]] = layout.boxes[i].min.y;
    EXPECT_EQ(layout.boxes[i].min.y, line[depth[i]]);
  }
}

// Decorator 0 on decorator 1 on leaf 2.
TEST(TreeLayout, LaysDecoratorsOnTheirChildWhenCompact) {
  LayoutStyle style;
  style.compact = true;
  const MeasuredTree tree = {
      {3, 3, 3}, {Point{60, 24}, Point{90, 24}, Point{140, 50}}, {true, true, false}};
  const TreeLayout layout = Arrange(tree, style, {});
  EXPECT_EQ(layout.links, (std::vector<Link>{Link::kNone, Link::kNone, Link::kNone}));
  for (const Box& box : layout.boxes) {
    EXPECT_EQ(box.min.x, 0);
    EXPECT_EQ(box.max.x, 140);
  }
  EXPECT_LT(layout.boxes[1].min.y - layout.boxes[0].max.y, 4);
  EXPECT_LT(layout.boxes[2].min.y - layout.boxes[1].max.y, 4);
}

TEST(TreeLayout, IsFlatterForATreeOfDecoratorsWhenCompact) {
  MeasuredTree tree = Plain(std::vector<std::uint32_t>(20, 20), {100, 24});
  for (std::uint32_t i = 0; i < 19; ++i) tree.is_decorator[i] = i % 3 != 0;
  LayoutStyle style;
  const float loose = Arrange(tree, style, {}).bounds.height();
  style.compact = true;
  EXPECT_LT(Arrange(tree, style, {}).bounds.height(), loose * 0.7F);
}

LayoutStyle Stacked() {
  LayoutStyle style;
  style.stacked = true;
  return style;
}

TEST(TreeLayout, StacksLeavesBeyondEightIfTold) {
  for (const std::uint32_t leaves : {8U, 9U}) {
    std::vector<std::uint32_t> ends = {leaves + 1};
    for (std::uint32_t i = 1; i <= leaves; ++i) ends.push_back(i + 1);
    const TreeLayout layout = Arrange(Plain(ends, {100, 24}), Stacked(), {});
    const bool column = layout.boxes[1].min.x == layout.boxes[leaves].min.x;
    EXPECT_EQ(column, leaves > kMostLeavesInARow);
    EXPECT_EQ(layout.links[1], column ? Link::kTrunk : Link::kCurve);
  }
}

// A root and so many leaves.
TreeLayout LayOutLeaves(std::uint32_t leaves, const LayoutStyle& style) {
  std::vector<std::uint32_t> ends = {leaves + 1};
  for (std::uint32_t i = 1; i <= leaves; ++i) ends.push_back(i + 1);
  return Arrange(Plain(ends, {160, 30}), style, {});
}

TEST(TreeLayout, PutsVeryManyLeavesIntoSeveralColumns) {
  const Box stacked = LayOutLeaves(500, Stacked()).bounds;
  EXPECT_LT(stacked.width(), 4 * stacked.height());
  EXPECT_LT(stacked.height(), 2 * stacked.width());
}

// Twenty nodes with two children each: not some in rows and others beside each other.
TEST(TreeLayout, IsOfOneStyleThroughout) {
  std::vector<std::uint32_t> ends = {61};
  for (std::uint32_t i = 0; i < 20; ++i) {
    const std::uint32_t at = 1 + 3 * i;
    ends.insert(ends.end(), {at + 3, at + 2, at + 3});
  }
  LayoutChoice choice;
  for (const float rows : {0.0F, 600.0F}) {
    choice.rows = rows;
    const TreeLayout layout = Arrange(Plain(ends, {160, 30}), {}, choice);
    for (std::size_t i = 1; i < layout.links.size(); ++i) {
      EXPECT_EQ(layout.links[i], rows > 0 ? Link::kRow : Link::kCurve) << i;
    }
  }
}

TEST(TreeLayout, TheRootOfATidyTreeStandsAboveTheMiddleOfItsChildren) {
  const TreeLayout layout = LayOutLeaves(7, {});
  EXPECT_NEAR(layout.boxes[0].center().x, layout.boxes[4].center().x, 0.01);
}

TEST(TreeLayout, StacksOnlyTheLeavesThatFollowEachOther) {
  // Nine leaves, then a node with a child, then one leaf.
  std::vector<std::uint32_t> ends = {13};
  for (std::uint32_t i = 1; i <= 9; ++i) ends.push_back(i + 1);
  ends.insert(ends.end(), {12, 12, 13});
  const TreeLayout layout = Arrange(Plain(ends, {100, 24}), Stacked(), {});
  EXPECT_EQ(layout.links[9], Link::kTrunk);
  EXPECT_EQ(layout.links[10], Link::kCurve);
  EXPECT_EQ(layout.links[12], Link::kCurve);
  EXPECT_GT(layout.boxes[12].min.x, layout.boxes[10].max.x);
}

TEST(TreeLayout, LaysOut10000NodesInMilliseconds) {
  const RandomTree tree = MakeTree(10000, 1);
  double best = 1e9;
  for (int i = 0; i < 10; ++i) {
    const auto start = std::chrono::steady_clock::now();
    Arrange(tree, {}, {});
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    best = std::min(best, took.count());
  }
  std::printf("layout of 10 000 nodes: %.2f ms\n", best);
  RecordProperty("milliseconds", std::to_string(best));
  EXPECT_LT(best, 10);
}

}  // namespace
}  // namespace coppice::editor
