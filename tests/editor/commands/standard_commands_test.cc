#include "editor/commands/standard_commands.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class StandardCommandsTest : public testing::Test {
 protected:
  StandardCommandsTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(StandardCommandsTest, WalkTheTreeWithTheArrowKeys) {
  driver_.Press(kKeyDown);
  EXPECT_EQ(driver_.Selected(), "1");
  driver_.Press(kKeyDown);
  EXPECT_EQ(driver_.Selected(), "1.1");
  driver_.Press(kKeyRight);
  EXPECT_EQ(driver_.Selected(), "1.2");
  driver_.Press(kKeyDown);
  EXPECT_EQ(driver_.Selected(), "1.2.1");
  driver_.Press(kKeyUp);
  driver_.Press(kKeyLeft);
  EXPECT_EQ(driver_.Selected(), "1.1");
  driver_.Press(kKeyLeft);
  EXPECT_EQ(driver_.Selected(), "1.1") << "nothing further left";
}

TEST_F(StandardCommandsTest, WalkAsTheScreenShowsItWhenTheTreeLiesOnItsSide) {
  driver_.Click("canvasbar/lr");
  driver_.Press(kKeyRight);
  driver_.Press(kKeyRight);
  EXPECT_EQ(driver_.Selected(), "1.1");
  driver_.Press(kKeyDown);
  EXPECT_EQ(driver_.Selected(), "1.2");
  driver_.Press(kKeyLeft);
  EXPECT_EQ(driver_.Selected(), "1");
}

TEST_F(StandardCommandsTest, CollapseTheSelectionWithC) {
  driver_.Click("canvas/MainTree/1.1");
  driver_.Press('C');
  driver_.Frames(15);
  EXPECT_FALSE(driver_.Has("canvas/MainTree/1.1.1"));
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.1/toggle"));
  driver_.Press('C');
  driver_.Frames(15);
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.1.1"));
}

TEST_F(StandardCommandsTest, NodesJumpInsteadOfGlidingWithReducedMotion) {
  driver_.view().SetCollapsed(1, true, driver_.editor.now());
  EXPECT_TRUE(driver_.view().IsMoving(driver_.editor.now()));
  driver_.Frames(20);
  ASSERT_TRUE(driver_.Click("menu/view"));
  ASSERT_TRUE(driver_.Click("menu/view.reduce_motion"));
  EXPECT_TRUE(driver_.editor.state().screen.reduce_motion);
  driver_.view().SetCollapsed(1, false, driver_.editor.now());
  EXPECT_FALSE(driver_.view().IsMoving(driver_.editor.now()));
}

TEST_F(StandardCommandsTest, CloseAndOpenAllSubTrees) {
  driver_.Press('E', kShift);
  driver_.Frames(15);
  EXPECT_FALSE(driver_.Has("canvas/MainTree/1.2.1"));
  driver_.Press('E');
  driver_.Frames(15);
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.2.1.1"));
}

TEST_F(StandardCommandsTest, FitSelectionAndFitAll) {
  const float all = driver_.BoxOf("canvas/MainTree/1").width();
  driver_.Click("canvas/MainTree/1.1.2");
  driver_.Press(kKeyPeriod);
  const float close = driver_.BoxOf("canvas/MainTree/1.1.2").width();
  driver_.Press(kKeyHome);
  EXPECT_LT(driver_.BoxOf("canvas/MainTree/1.1.2").width(), close);
  EXPECT_NEAR(driver_.BoxOf("canvas/MainTree/1").width(), all, 1);
}

TEST_F(StandardCommandsTest, HideAndShowEveryTileByItsKey) {
  struct {
    int key;
    int modifiers;
    const char* path;
  } const kTiles[] = {{3, kCtrl, "outline"},
                      {4, kNoModifier, "inspector"},
                      {6, kNoModifier, "blackboard"},
                      {7, kNoModifier, "xml"},
                      {8, kNoModifier, "problems"}};
  driver_.OpenRow();
  for (const auto& [key, modifiers, path] : kTiles) {
    driver_.Press(kKeyF1 + key - 1, modifiers);
    EXPECT_FALSE(driver_.Has(path)) << path;
    driver_.Press(kKeyF1 + key - 1, modifiers);
    EXPECT_TRUE(driver_.Has(path)) << path;
  }
}

TEST_F(StandardCommandsTest, HideTheProjectTileWithShiftF2) {
  driver_.Press(kKeyF1 + 1, kShift);
  EXPECT_FALSE(driver_.Has("project"));
}

TEST_F(StandardCommandsTest, QuitWithCtrlQ) {
  EXPECT_FALSE(driver_.editor.wants_quit());
  driver_.Press('Q', kCtrl);
  EXPECT_TRUE(driver_.editor.wants_quit());
}

TEST_F(StandardCommandsTest, SwitchRobotsWithControlTab) {
  driver_.AddRobot("one:1", kLiveTree);
  driver_.AddRobot("two:2", kLiveTree);
  EXPECT_EQ(driver_.editor.state().workspace.run()->name(), "two:2");
  driver_.Press(kKeyTab, kCtrl);
  EXPECT_EQ(driver_.editor.state().workspace.run()->name(), "one:1");
  driver_.Press(kKeyTab, kCtrl);
  EXPECT_EQ(driver_.editor.state().workspace.run()->name(), "two:2");
}

}  // namespace
}  // namespace coppice::editor
