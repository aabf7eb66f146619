// The rectangle that selects, the mark where something would go, and the end of a drag:
// editor/canvas/canvas_gesture.cc.
#include <gtest/gtest.h>

#include <utility>

#include "editor/canvas/canvas_mouse.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class CanvasGestureTest : public testing::Test {
 protected:
  CanvasGestureTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  Box BoxOf(const std::string& node) const { return driver_.BoxOf("canvas/MainTree/" + node); }
  std::vector<std::string> Selection() {
    std::vector<std::string> paths;
    for (const std::uint32_t node : driver_.view().selection()) {
      paths.push_back(driver_.view().scene()->nodes[node].path);
    }
    return paths;
  }
  void Drag(Point from, Point to, int modifiers) {
    driver_.Hold(modifiers);
    driver_.Drag(from, to);
    driver_.Hold(kNoModifier);
  }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(CanvasGestureTest, TheRectangleTakesWhatItTouchesFromAnyCorner) {
  const Box a = BoxOf("1.1.1");
  const Box b = BoxOf("1.1.2");
  Drag({b.max.x + 6, b.min.y + 10}, {a.min.x - 12, a.min.y - 4}, kShift);
  EXPECT_EQ(Selection(), (std::vector<std::string>{"1.1.1", "1.1.2"}));
}

TEST_F(CanvasGestureTest, WithShiftTheRectangleBeginsAnew) {
  driver_.Click("canvas/MainTree/1.3");
  const Box a = BoxOf("1.1.2");
  Drag({a.max.x + 6, a.max.y + 6}, {a.max.x - 6, a.max.y - 6}, kShift);
  EXPECT_EQ(Selection(), (std::vector<std::string>{"1.1.2"}));
}

TEST_F(CanvasGestureTest, WithCtrlItAddsToTheSelection) {
  driver_.Click("canvas/MainTree/1.3");
  const Box a = BoxOf("1.1.2");
  Drag({a.max.x + 6, a.max.y + 6}, {a.max.x - 6, a.max.y - 6}, kCtrl);
  EXPECT_EQ(Selection(), (std::vector<std::string>{"1.1.2", "1.3"}));
}

TEST_F(CanvasGestureTest, ARectangleOverNothingSelectsNothing) {
  driver_.Click("canvas/MainTree/1.3");
  const Box canvas = driver_.BoxOf("canvas");
  const Point at = {canvas.min.x + 10, canvas.max.y - 30};
  Drag(at, at + Point{20, 20}, kShift);
  EXPECT_TRUE(Selection().empty());
}

TEST_F(CanvasGestureTest, TheRectangleIsGoneAsSoonAsTheButtonIs) {
  const Box a = BoxOf("1.1.2");
  Drag({a.max.x + 6, a.max.y + 6}, {a.max.x - 6, a.max.y - 6}, kShift);
  EXPECT_EQ(driver_.view().gesture.kind, Gesture::Kind::kNone);
}

TEST_F(CanvasGestureTest, ABarStandsWhereANodeWouldGo) {
  const Box first = BoxOf("1.1");
  const Box second = BoxOf("1.2");
  driver_.Carry(BoxOf("1.3").center(), {second.min.x + 3, second.center().y});
  const Box bar = driver_.BoxOf("canvas/drop");
  EXPECT_GT(bar.center().x, first.max.x - 1);
  EXPECT_LT(bar.center().x, second.min.x + 1);
  EXPECT_LT(bar.width(), 8);
  EXPECT_GE(bar.height(), second.height());
}

TEST_F(CanvasGestureTest, AFrameStandsAroundTheNodeThatWouldTakeIt) {
  const Box into = BoxOf("1.1");
  driver_.Carry(BoxOf("1.3").center(), into.center());
  const Box mark = driver_.BoxOf("canvas/drop");
  EXPECT_NEAR(mark.min.x, into.min.x, 1);
  EXPECT_NEAR(mark.max.x, into.max.x, 1);
}

TEST_F(CanvasGestureTest, WhereNothingWouldGoThereIsNoMark) {
  const Box canvas = driver_.BoxOf("canvas");
  driver_.Carry(BoxOf("1.3").center(), {canvas.min.x + 60, canvas.max.y - 60});
  EXPECT_FALSE(driver_.Has("canvas/drop"));
  EXPECT_TRUE(driver_.Has("canvas/ghost"));
  driver_.input.events.emplace_back(std::in_place_type<MouseButton>, MouseButton{0, false});
  driver_.Frames();
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(CanvasGestureTest, AtTheBorderOfTheCanvasTheTreeComesToMeetTheMouse) {
  const Box canvas = driver_.BoxOf("canvas");
  const float before = driver_.view().camera.offset.x;
  driver_.Carry(BoxOf("1.3").center(), {canvas.max.x - 5, canvas.center().y});
  driver_.Frames(10);
  EXPECT_LT(driver_.view().camera.offset.x, before - 20);
  driver_.MoveTo(canvas.center());
  const float inside = driver_.view().camera.offset.x;
  driver_.Frames(10);
  EXPECT_EQ(driver_.view().camera.offset.x, inside);
}

TEST_F(CanvasGestureTest, OutsideOfTheCanvasNothingIsDropped) {
  driver_.Drag(BoxOf("1.3").center(), driver_.BoxOf("blackboard").center());
  EXPECT_EQ(Text(), kSmallFile);
  EXPECT_EQ(driver_.view().gesture.kind, Gesture::Kind::kNone);
}

}  // namespace
}  // namespace coppice::editor
