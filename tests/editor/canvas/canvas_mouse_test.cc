#include "editor/canvas/canvas_mouse.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class CanvasMouseTest : public testing::Test {
 protected:
  CanvasMouseTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  Box BoxOf(const std::string& node) const { return driver_.BoxOf("canvas/MainTree/" + node); }
  Point Free() const {
    const Box canvas = driver_.BoxOf("canvas");
    return {canvas.min.x + 20, canvas.max.y - 20};
  }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(CanvasMouseTest, AClickOnTheEmptyCanvasSelectsNothing) {
  driver_.Click("canvas/MainTree/1.1.2");
  ASSERT_EQ(driver_.Selected(), "1.1.2");
  driver_.ClickAt(Free());
  EXPECT_EQ(driver_.Selected(), "");
}

TEST_F(CanvasMouseTest, WithCtrlAClickOnTheEmptyCanvasKeepsTheSelection) {
  driver_.Click("canvas/MainTree/1.1.2");
  driver_.Hold(kCtrl);
  driver_.ClickAt(Free());
  driver_.Hold(kNoModifier);
  EXPECT_EQ(driver_.Selected(), "1.1.2");
}

TEST_F(CanvasMouseTest, AMoveOfAFewPixelsIsStillAClick) {
  const Point at = BoxOf("1.3").center();
  driver_.Drag(at, at + Point{2, 1});
  EXPECT_EQ(driver_.Selected(), "1.3");
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(CanvasMouseTest, TheMiddleButtonMovesTheCanvasAlsoOverANode) {
  const Box before = BoxOf("1.1");
  driver_.Drag(before.center(), before.center() + Point{50, 30}, 2);
  EXPECT_NEAR(BoxOf("1.1").min.x, before.min.x + 50, 1);
  EXPECT_NEAR(BoxOf("1.1").min.y, before.min.y + 30, 1);
  EXPECT_EQ(Text(), kSmallFile) << "nothing was dropped";
}

TEST_F(CanvasMouseTest, ZoomingKeepsWhatIsBelowTheMouse) {
  const Point at = BoxOf("1.2").center();
  driver_.MoveTo(at);
  driver_.Zoom(2);
  EXPECT_TRUE(BoxOf("1.2").Contains(at));
  driver_.Zoom(-5);
  EXPECT_TRUE(BoxOf("1.2").Contains(at));
}

TEST_F(CanvasMouseTest, ADoubleClickClosesABranchAndTheChipOpensIt) {
  const Point at = BoxOf("1.1").center();
  driver_.ClickAt(at);
  driver_.ClickAt(at);
  driver_.Frames(12);
  EXPECT_FALSE(driver_.Has("canvas/MainTree/1.1.1"));
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.1/toggle"));
  driver_.Frames(12);
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.1.1"));
}

TEST_F(CanvasMouseTest, ADoubleClickOnASubTreeOpensItsTree) {
  const Box box = BoxOf("1.2");
  const Point title = {box.min.x + 40, box.min.y + 8};
  driver_.ClickAt(title);
  driver_.ClickAt(title);
  driver_.Frames(12);
  EXPECT_EQ(driver_.view().scene()->tree_id, "Walk");
}

TEST_F(CanvasMouseTest, FromFarAwayTheToggleOfASubTreeIsPartOfTheNode) {
  driver_.view().camera.zoom = 0.2F;
  driver_.Frames();
  const Box box = BoxOf("1.2");
  driver_.ClickAt({box.max.x - 2, box.min.y + 2});
  EXPECT_EQ(driver_.Selected(), "1.2");
  EXPECT_FALSE(driver_.view().IsCollapsed(driver_.view().selected()));
}

TEST_F(CanvasMouseTest, EscapeEndsADragAndNothingIsDropped) {
  driver_.Carry(BoxOf("1.3").center(), BoxOf("1.1").center());
  ASSERT_TRUE(driver_.Has("canvas/ghost"));
  driver_.Press(kKeyEscape);
  EXPECT_FALSE(driver_.Has("canvas/ghost"));
  driver_.input.events.emplace_back(std::in_place_type<MouseButton>, MouseButton{0, false});
  driver_.Frames();
  EXPECT_EQ(Text(), kSmallFile);
}

// What lies in a branch that is carried comes with it, and is not moved a second time.
TEST_F(CanvasMouseTest, CarriesEverySelectedBranchOnce) {
  driver_.Click("canvas/MainTree/1.1");
  driver_.Hold(kCtrl);
  driver_.Click("canvas/MainTree/1.1.2");
  driver_.Click("canvas/MainTree/1.3");
  driver_.Hold(kNoModifier);
  ASSERT_EQ(driver_.view().selection().size(), 3U);
  driver_.Carry(BoxOf("1.3").center(), BoxOf("1.3").center() + Point{30, 30});
  ASSERT_EQ(driver_.view().gesture.kind, Gesture::Kind::kDrag);
  EXPECT_EQ(driver_.view().gesture.drag.nodes.size(), 2U);
  EXPECT_EQ(driver_.view().gesture.drag.label, "Fallback and 1 more");
}

TEST_F(CanvasMouseTest, WhoDragsANodeThatIsNotSelectedDragsItAlone) {
  driver_.Click("canvas/MainTree/1.1");
  driver_.Carry(BoxOf("1.3").center(), BoxOf("1.3").center() + Point{30, 30});
  EXPECT_EQ(driver_.Selected(), "1.3");
  EXPECT_EQ(driver_.view().gesture.drag.nodes.size(), 1U);
}

}  // namespace
}  // namespace coppice::editor
