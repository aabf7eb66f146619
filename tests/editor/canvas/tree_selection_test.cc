#include <gtest/gtest.h>

#include "editor/canvas/tree_view.h"
#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

using Nodes = std::vector<std::uint32_t>;

// 0 Sequence: 1 A, 2 Fallback (3 B, 4 C), 5 D
class TreeSelectionTest : public testing::Test {
 protected:
  TreeSelectionTest() {
    view_.SetScene(MakeScene("<Sequence><A/><Fallback><B/><C/></Fallback><D/></Sequence>"),
                   SameSize, 0);
  }
  TreeView view_;
};

TEST_F(TreeSelectionTest, IsOneNodeOrSeveralOrNone) {
  view_.Select(1);
  EXPECT_EQ(view_.selection(), Nodes{1});
  view_.ToggleSelected(5);
  EXPECT_EQ(view_.selection(), (Nodes{1, 5}));
  EXPECT_EQ(view_.selected(), 5U) << "the last one counts";
  EXPECT_TRUE(view_.IsSelected(1));
  view_.ToggleSelected(5);
  EXPECT_EQ(view_.selection(), Nodes{1});
  view_.Select(kNoSceneNode);
  EXPECT_TRUE(view_.selection().empty());
  EXPECT_EQ(view_.selected(), kNoSceneNode);
}

TEST_F(TreeSelectionTest, AmongSiblingsItTakesTheSiblingsBetween) {
  view_.Select(5);
  view_.SelectTo(1);
  EXPECT_EQ(view_.selection(), (Nodes{1, 2, 5})) << "not what is below them";
  EXPECT_EQ(view_.selected(), 1U);
}

TEST_F(TreeSelectionTest, ElseAllVisibleNodesBetween) {
  view_.Select(1);
  view_.SelectTo(4);
  EXPECT_EQ(view_.selection(), (Nodes{1, 2, 3, 4}));
  view_.Select(kNoSceneNode);
  view_.SelectTo(3);
  EXPECT_EQ(view_.selection(), Nodes{3}) << "without a beginning that node alone";
}

TEST_F(TreeSelectionTest, WhatIsSelectedIsNotHidden) {
  view_.SetCollapsed(2, true, 0);
  ASSERT_EQ(view_.shown().size(), 4U);
  view_.Select(4);
  EXPECT_FALSE(view_.IsCollapsed(2));
  EXPECT_EQ(view_.shown().size(), 6U);
}

TEST_F(TreeSelectionTest, TheSameNodeTwiceIsOne) {
  view_.SelectAll({5, 1, 5, 3});
  EXPECT_EQ(view_.selection(), (Nodes{1, 3, 5}));
  EXPECT_EQ(view_.selected(), 3U);
}

}  // namespace
}  // namespace coppice::editor
