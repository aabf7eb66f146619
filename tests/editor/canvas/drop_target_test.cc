#include "editor/canvas/drop_target.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

constexpr double kLater = 9;

class DropTargetTest : public testing::Test {
 protected:
  void Show(const std::string& xml, LayoutStyle style = {}) {
    scene_ = MakeScene(xml);
    view_.SetStyle(style, 0);
    view_.SetScene(scene_, SameSize, 0);
  }
  Box BoxOf(const char* path) { return view_.BoxAt(view_.ShownOf(scene_->FindPath(path)), kLater); }
  DropTarget At(Point point) const { return FindDropTarget(view_, point, kLater); }
  // "gap 1.2 0": place, path of the node, index.
  std::string Text(const DropTarget& target) const {
    if (target.place == DropPlace::kNowhere) return "nowhere";
    const std::string path = scene_->nodes[target.node].path;
    if (target.place == DropPlace::kNode) return "node " + path;
    if (target.place == DropPlace::kEdge) return "edge " + path;
    return "gap " + path + " " + std::to_string(target.index);
  }
  std::shared_ptr<const Scene> scene_;
  TreeView view_;
};

TEST_F(DropTargetTest, IsTheNodeInItsMiddle) {
  Show("<A><B/><C/></A>");
  EXPECT_EQ(Text(At(BoxOf("1.2").center())), "node 1.2");
  EXPECT_EQ(Text(At(BoxOf("1").center())), "node 1");
}

TEST_F(DropTargetTest, IsTheGapBesideANodeAtItsSides) {
  Show("<A><B/><C/></A>");
  const Box c = BoxOf("1.2");
  EXPECT_EQ(Text(At({c.min.x + 3, c.center().y})), "gap 1 1");
  EXPECT_EQ(Text(At({c.max.x - 3, c.center().y})), "gap 1 2");
}

TEST_F(DropTargetTest, IsTheGapBetweenBeforeAndBehindSiblings) {
  Show("<A><B/><C/><D/></A>");
  const float y = BoxOf("1.1").center().y;
  EXPECT_EQ(Text(At({BoxOf("1.1").min.x - 15, y})), "gap 1 0");
  EXPECT_EQ(Text(At({(BoxOf("1.1").max.x + BoxOf("1.2").min.x) / 2, y})), "gap 1 1");
  EXPECT_EQ(Text(At({BoxOf("1.3").max.x + 15, y})), "gap 1 3");
}

TEST_F(DropTargetTest, MarksTheMiddleBetweenTwoSiblings) {
  Show("<A><B/><C/></A>");
  const float middle = (BoxOf("1.1").max.x + BoxOf("1.2").min.x) / 2;
  EXPECT_NEAR(At({middle, BoxOf("1.1").center().y}).mark.center().x, middle, 0.01);
  EXPECT_NEAR(At({BoxOf("1.1").max.x - 2, BoxOf("1.1").center().y}).mark.center().x, middle, 0.01);
}

TEST_F(DropTargetTest, IsTheLineBetweenParentAndChild) {
  Show("<A><B/><C/></A>");
  const Box parent = BoxOf("1");
  const Box child = BoxOf("1.2");
  EXPECT_EQ(Text(At({child.center().x, child.min.y - 2})), "edge 1.2");
  const Point middle = {(parent.center().x + child.center().x) / 2,
                        (parent.max.y + child.min.y) / 2};
  EXPECT_EQ(Text(At(middle)), "edge 1.2");
}

TEST_F(DropTargetTest, IsAboveTheRoot) {
  Show("<A><B/></A>");
  EXPECT_EQ(Text(At({BoxOf("1").center().x, BoxOf("1").min.y - 12})), "edge 1");
}

TEST_F(DropTargetTest, IsNowhereFarAway) {
  Show("<A><B/></A>");
  EXPECT_EQ(Text(At({900, 900})), "nowhere");
  EXPECT_EQ(Text(At({-300, 10})), "nowhere");
}

TEST_F(DropTargetTest, LooksAboveAndBelowInAColumn) {
  LayoutStyle across;
  across.growth = Growth::kAcross;
  Show("<A><B/><C/></A>", across);
  const Box c = BoxOf("1.2");
  EXPECT_EQ(Text(At({c.center().x, c.min.y + 2})), "gap 1 1");
  EXPECT_EQ(Text(At({c.center().x, c.max.y + 8})), "gap 1 2");
  LayoutStyle stacked;
  stacked.stacked = true;
  Show("<A><B/><B/><B/><B/><B/><B/><B/><B/><B/></A>", stacked);
  const Box fifth = BoxOf("1.5");
  EXPECT_EQ(Text(At({fifth.center().x, fifth.max.y + 4})), "gap 1 5");
  EXPECT_EQ(Text(At(fifth.center())), "node 1.5");
}

// Sixty siblings in rows: the bar behind the last of a row stands beside it, not half way to the
// first of the next one.
TEST_F(DropTargetTest, StaysInItsRow) {
  std::string xml = "<A>";
  for (int i = 0; i < 60; ++i) xml += "<B><C/></B>";
  Show(xml + "</A>");
  view_.FitAll({800, 600});
  std::uint32_t last = 1;
  while (BoxOf(("1." + std::to_string(last + 1)).c_str()).min.y == BoxOf("1.1").min.y) ++last;
  ASSERT_LT(last, 59U);
  const Box end = BoxOf(("1." + std::to_string(last)).c_str());
  const DropTarget behind = At({end.max.x - 3, end.center().y});
  EXPECT_EQ(Text(behind), "gap 1 " + std::to_string(last));
  EXPECT_NEAR(behind.mark.center().x, end.max.x + 7, 4);
  const Box begin = BoxOf(("1." + std::to_string(last + 1)).c_str());
  const DropTarget before = At({begin.min.x + 3, begin.center().y});
  EXPECT_EQ(Text(before), "gap 1 " + std::to_string(last)) << "the same place";
  EXPECT_NEAR(before.mark.center().y, begin.center().y, 1) << "but in the next row";
}

TEST_F(DropTargetTest, IsTheLineAlongTheRows) {
  std::string xml = "<A>";
  for (int i = 0; i < 60; ++i) xml += "<B><C/></B>";
  Show(xml + "</A>");
  view_.FitAll({800, 600});
  const Box child = BoxOf("1.60");
  EXPECT_EQ(Text(At({child.center().x, child.min.y - 4})), "edge 1.60");
}

TEST_F(DropTargetTest, IsTheLineAboveAChildThatItsDecoratorLiesOn) {
  LayoutStyle style;
  style.compact = true;
  Show("<Inverter><B/></Inverter>", style);
  const Box b = BoxOf("1.1");
  EXPECT_EQ(Text(At({b.center().x, b.min.y + 2})), "edge 1.1");
  EXPECT_EQ(Text(At({b.center().x, b.max.y - 5})), "node 1.1");
}

TEST_F(DropTargetTest, AcceptsAnEmptyTree) {
  scene_ = std::make_shared<Scene>();
  view_.SetScene(scene_, SameSize, 0);
  EXPECT_EQ(At({0, 0}).place, DropPlace::kNowhere);
}

}  // namespace
}  // namespace coppice::editor
