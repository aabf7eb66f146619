#include <gtest/gtest.h>

#include "editor/canvas/tree_view.h"
#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

constexpr Box kAnchorCanvas{{200, 60}, {1000, 660}};

class TreeAnchorTest : public testing::Test {
 protected:
  TreeAnchorTest() {
    Show("<A><B><C/><D/></B><E><F/><G/></E></A>");
    view_.PlaceIn(kAnchorCanvas);
  }

  void Show(const std::string& xml) { view_.SetScene(MakeScene(xml), SameSize, now_); }

  std::uint32_t Find(const std::string& id) const {
    const auto& nodes = view_.scene()->nodes;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].id == id) return i;
    }
    return kNoSceneNode;
  }
  // On the screen, at rest.
  Point PlaceOf(const std::string& id) const {
    const Box box = view_.BoxAt(view_.ShownOf(Find(id)), now_ + 1);
    return view_.camera.ToScreen(box.min) + kAnchorCanvas.min;
  }
  void PointAt(const std::string& id) { view_.mouse = PlaceOf(id) + Point{5, 5}; }
  void ExpectStill(const std::string& id, Point before) const {
    EXPECT_NEAR(PlaceOf(id).x, before.x, 0.1) << id;
    EXPECT_NEAR(PlaceOf(id).y, before.y, 0.1) << id;
  }

  double now_ = 5;
  TreeView view_;
};

TEST_F(TreeAnchorTest, IsTheNodeBelowTheMouse) {
  view_.Select(Find("G"));
  PointAt("C");
  const Point before = PlaceOf("C");
  Show("<A><New/><B><C/><D/></B><E><F/><G/></E></A>");
  ExpectStill("C", before);
}

TEST_F(TreeAnchorTest, IsAlsoANodeWithinReachOfTheMouse) {
  view_.Select(Find("G"));
  view_.mouse = PlaceOf("C") - Point{30, 0};
  const Point before = PlaceOf("C");
  Show("<A><New/><B><C/><D/></B><E><F/><G/></E></A>");
  ExpectStill("C", before);
}

TEST_F(TreeAnchorTest, IsTheSelectedNodeWithoutAMouse) {
  view_.Select(Find("G"));
  const Point before = PlaceOf("G");
  Show("<A><New/><B><C/><D/></B><E><F/><G/></E></A>");
  ExpectStill("G", before);
}

TEST_F(TreeAnchorTest, IsTheNodeInTheMiddleIfTheSelectedOneIsOutOfSight) {
  view_.Select(Find("A"));
  view_.camera.zoom = 8;
  view_.camera.offset = Point{400, 300} - view_.BoxAt(view_.ShownOf(Find("C")), 9).center() * 8;
  const Point before = PlaceOf("C");
  Show("<A><New/><B><C/><D/></B><E><F/><G/></E></A>");
  ExpectStill("C", before);
}

TEST_F(TreeAnchorTest, IsTheNearestAboveOneThatWentAway) {
  PointAt("C");
  const Point before = PlaceOf("B");
  Show("<A><B><D/></B><E><F/><G/></E></A>");
  ExpectStill("B", before);
}

TEST_F(TreeAnchorTest, IsTheRootIfNothingIsLeftOfTheTree) {
  PointAt("C");
  const Point before = PlaceOf("A");
  Show("<X><Y/></X>");
  ExpectStill("X", before);
}

TEST_F(TreeAnchorTest, IsNotWhatTheMouseCarries) {
  view_.Select(Find("F"));
  view_.mouse = PlaceOf("F") + Point{95, 5};
  view_.gesture.drag.nodes = {Find("F")};
  const Point before = PlaceOf("G");
  Show("<A><B><C/><F/><D/></B><E><G/></E></A>");
  ExpectStill("G", before);
}

TEST_F(TreeAnchorTest, HoldsThroughEveryChoiceOfAStyle) {
  const LayoutStyle before = view_.style();
  for (const auto change : {+[](LayoutStyle& style) { style.growth = Growth::kAcross; },
                            +[](LayoutStyle& style) { style.ports = ShownPorts::kNone; },
                            +[](LayoutStyle& style) { style.layered = true; },
                            +[](LayoutStyle& style) { style.compact = !style.compact; }}) {
    PointAt("D");
    const Point place = PlaceOf("D");
    LayoutStyle style = before;
    change(style);
    view_.SetStyle(style, now_);
    view_.PlaceIn(kAnchorCanvas);
    ExpectStill("D", place);
    view_.SetStyle(before, now_);
    view_.PlaceIn(kAnchorCanvas);
    ExpectStill("D", place);
  }
}

TEST_F(TreeAnchorTest, ATreeThatIsFittedIsFittedToANewStyleIfNothingHoldsIt) {
  LayoutStyle style;
  style.growth = Growth::kAcross;
  view_.SetStyle(style, now_);
  view_.PlaceIn(kAnchorCanvas);
  TreeView fitted = view_;
  fitted.FitAll({kAnchorCanvas.width(), kAnchorCanvas.height()});
  EXPECT_EQ(view_.camera, fitted.camera);
}

TEST_F(TreeAnchorTest, HoldsWhenATileOpensAndTheTreeStillFits) {
  PointAt("C");
  const Point before = PlaceOf("C");
  view_.PlaceIn({kAnchorCanvas.min, kAnchorCanvas.max - Point{10, 0}});
  ExpectStill("C", before);
  view_.PlaceIn({kAnchorCanvas.min, kAnchorCanvas.max + Point{150, 100}});
  ExpectStill("C", before);
}

TEST_F(TreeAnchorTest, GivesWayToATileThatWouldHideATreeThatWasWhole) {
  PointAt("C");
  const Box narrow = {kAnchorCanvas.min, {kAnchorCanvas.min.x + 200, kAnchorCanvas.max.y}};
  view_.PlaceIn(narrow);
  const Box tree = view_.camera.ToScreen(view_.bounds());
  EXPECT_GE(tree.min.x, 0);
  EXPECT_LE(tree.max.x, 200);
}

TEST_F(TreeAnchorTest, IsTheFoldedNodeIfTheMouseIsOnWhatItHides) {
  PointAt("C");
  const Point before = PlaceOf("B");
  view_.SetCollapsed(Find("B"), true, now_);
  ExpectStill("B", before);
}

TEST_F(TreeAnchorTest, ANodeThatGetsSmallerIsStillBelowTheMouse) {
  const auto large = [](const Scene&, const SceneNode&) { return NodeSizes({220, 120}, {60, 26}); };
  view_ = {};
  view_.SetScene(MakeScene("<A><B/><C/></A>"), large, 0);
  view_.PlaceIn(kAnchorCanvas);
  const Point at = PlaceOf("C") + Point{200, 100} * view_.camera.zoom;
  view_.mouse = at;
  LayoutStyle style;
  style.ports = ShownPorts::kNone;
  view_.SetStyle(style, now_);
  const Box box = view_.camera.ToScreen(view_.BoxAt(view_.ShownOf(Find("C")), 9));
  EXPECT_LE(box.min.x, at.x - kAnchorCanvas.min.x + 0.1F);
  EXPECT_GE(box.max.x, at.x - kAnchorCanvas.min.x - 0.1F);
  EXPECT_GE(box.max.y, at.y - kAnchorCanvas.min.y - 0.1F);
}

TEST_F(TreeAnchorTest, RevealsAfterAnEditOnlyWhatIsNotSeen) {
  view_.Select(Find("G"));
  const Camera before = view_.camera;
  view_.RevealIfLost({kAnchorCanvas.width(), kAnchorCanvas.height()});
  EXPECT_EQ(view_.camera, before);
  view_.camera.offset = {5000, 0};
  view_.RevealIfLost({kAnchorCanvas.width(), kAnchorCanvas.height()});
  EXPECT_LT(PlaceOf("G").x, kAnchorCanvas.max.x);
}

}  // namespace
}  // namespace coppice::editor
