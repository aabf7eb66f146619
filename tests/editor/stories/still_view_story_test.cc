#include <gtest/gtest.h>

#include <cmath>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

// A tree with room for surprises: what is done at one end moves all the rest.
std::string File() {
  std::string text = R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence name="top">)";
  for (int room = 1; room <= 5; ++room) {
    const std::string n = std::to_string(room);
    text += "<Fallback name=\"room " + n + "\"><Look name=\"look " + n + "\" at=\"{goal}\"/>";
    text += "<Drive name=\"drive " + n + "\" to=\"{goal}\" speed=\"0.5\"/></Fallback>";
  }
  return text + "</Sequence></BehaviorTree></root>";
}

class StillViewStory : public testing::Test {
 protected:
  StillViewStory() {
    driver_.editor.Open(file_.path());
    driver_.Frames(20);
  }
  Box BoxOf(const std::string& node) const { return driver_.BoxOf("canvas/T/" + node); }
  // Lets everything come to rest, and says how far the node has gone.
  float Shift(const std::string& node, Point from) {
    driver_.Frames(20);
    const Point way = BoxOf(node).min - from;
    return std::hypot(way.x, way.y);
  }

  // What does not stand still beside it: something has happened.
  void ExpectMoved(const std::string& node, Point from) {
    const Point way = BoxOf(node).min - from;
    EXPECT_GT(std::hypot(way.x, way.y), 5) << node << " has not moved";
  }

  TemporaryFile file_{"rooms.xml", File()};
  Driver driver_;
};

TEST_F(StillViewStory, ADropMovesNothingBelowTheMouse) {
  const Box target = BoxOf("1.4");
  driver_.Drag(BoxOf("1.1").center(), target.center());
  EXPECT_LE(Shift("1.3", target.min), 1) << "room 4, which is the third now";
}

TEST_F(StillViewStory, ANewNodeFromTheTilePushesNothingAway) {
  const Box target = BoxOf("1.4");
  const Box first = BoxOf("1.1");
  ASSERT_TRUE(driver_.Click("types/filter"));
  driver_.Type("Sequence");
  ASSERT_TRUE(driver_.Has("types/Sequence"));
  driver_.Drag(driver_.BoxOf("types/Sequence").center(), target.center());
  EXPECT_LE(Shift("1.4", target.min), 1);
  EXPECT_TRUE(driver_.Has("canvas/T/1.4.3")) << "the new node";
  ExpectMoved("1.1", first.min);
}

TEST_F(StillViewStory, DeleteUndoAndRedoKeepWhatIsBelowTheMouse) {
  driver_.Click("canvas/T/1.1");
  const Box other = BoxOf("1.4");
  driver_.MoveTo(other.center());
  driver_.Press(kKeyDelete);
  EXPECT_LE(Shift("1.3", other.min), 1);
  driver_.Press('Z', kCtrl);
  EXPECT_LE(Shift("1.4", other.min), 1);
  driver_.Press('Y', kCtrl);
  EXPECT_LE(Shift("1.3", other.min), 1);
}

TEST_F(StillViewStory, DeletingTheNodeBelowTheMouseKeepsItsParent) {
  const Box parent = BoxOf("1.4");
  const Box first = BoxOf("1.1");
  driver_.Click("canvas/T/1.4.2");
  driver_.Press(kKeyDelete);
  EXPECT_LE(Shift("1.4", parent.min), 1);
  EXPECT_FALSE(driver_.Has("canvas/T/1.4.2"));
  ExpectMoved("1.1", first.min);
}

TEST_F(StillViewStory, FoldingByKeyKeepsWhatIsBelowTheMouse) {
  driver_.Click("canvas/T/1.2");
  const Box other = BoxOf("1.4");
  driver_.MoveTo(other.center());
  for (const bool is_closed : {true, false}) {
    driver_.Press('C');
    EXPECT_LE(Shift("1.4", other.min), 1) << is_closed;
    EXPECT_NE(driver_.Has("canvas/T/1.2.1"), is_closed);
  }
}

TEST_F(StillViewStory, AnotherLayoutKeepsWhatIsBelowTheMouse) {
  const Box other = BoxOf("1.4");
  for (const char* title : {"Top to bottom", "All ports", "Names only", "Left to right"}) {
    const Box first = BoxOf("1.1");
    driver_.MoveTo(other.min + Point{4, 4});
    driver_.Press('P', kCtrl);
    driver_.Type(title);
    driver_.Press(kKeyEnter);
    EXPECT_LE(Shift("1.4", other.min), 1) << title;
    EXPECT_GT(Shift("1.1", first.min), 5) << title;
  }
}

TEST_F(StillViewStory, ATileThatLeavesRoomEnoughMovesNothing) {
  driver_.Zoom(-3);
  const Box other = BoxOf("1.4");
  driver_.MoveTo(other.center());
  ASSERT_TRUE(driver_.Has("inspector"));
  driver_.Press(kKeyF1 + 3);
  EXPECT_LE(Shift("1.4", other.min), 1) << "closed";
  EXPECT_FALSE(driver_.Has("inspector"));
  driver_.Press(kKeyF1 + 3);
  EXPECT_LE(Shift("1.4", other.min), 1) << "open";
  EXPECT_TRUE(driver_.Has("inspector"));
}

}  // namespace
}  // namespace coppice::editor
