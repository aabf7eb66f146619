#include "editor/canvas/visible_nodes.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

class VisibleNodesTest : public testing::Test {
 protected:
  VisibleNodesTest() {
    LayoutStyle style;
    style.wrapped = false;  // one wide row
    view_.SetStyle(style, 0);
    std::string leaves;
    for (int i = 0; i < 200; ++i) leaves += "<B><C/></B>";
    view_.SetScene(MakeScene("<A>" + leaves + "</A>"), SameSize, 0);
  }
  std::vector<VisibleNode> Find(Point offset, float zoom) const {
    Camera camera;
    camera.offset = offset;
    camera.zoom = zoom;
    return FindVisible(view_, camera, {{0, 0}, {800, 600}}, 10);
  }
  TreeView view_;
};

TEST_F(VisibleNodesTest, WhatIsOutOfSightIsNotAmongThem) {
  const auto near_the_left_end = Find({20, 20}, 1);
  EXPECT_LT(near_the_left_end.size(), 230U) << "the lines to the others start at the root";
  std::size_t leaves = 0;
  for (const VisibleNode& node : near_the_left_end) {
    leaves += view_.scene()->nodes[view_.shown()[node.k]].id == "C" ? 1 : 0;
  }
  EXPECT_GT(leaves, 3U);
  EXPECT_LT(leaves, 12U);
  EXPECT_TRUE(Find({-1e6F, 0}, 1).empty());
}

TEST_F(VisibleNodesTest, BranchesOfAFewPixelsAreOneBlock) {
  const auto all = Find({20, 20}, 0.01F);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].k, 0U);
  EXPECT_FALSE(all[0].whole_branch) << "the tree is wide";
  EXPECT_TRUE(all[1].whole_branch);
  EXPECT_EQ(all.size(), 201U) << "the leaves are in the blocks of their parents";
}

}  // namespace
}  // namespace coppice::editor
