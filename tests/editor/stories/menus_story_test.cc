#include <gtest/gtest.h>

#include "editor/workspace/canvas_tabs.h"
#include "tests/editor/driver.h"
#include "tests/editor/executed_source.h"
#include "tests/editor/reference_picture.h"

namespace coppice::editor {
namespace {

class MenusStory : public testing::Test {
 protected:
  MenusStory() {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
  }

  void RightClick(const std::string& path) {
    ASSERT_TRUE(driver_.Has(path)) << path;
    driver_.ClickAt(driver_.BoxOf(path).center(), 1);
    driver_.Frames();
    ASSERT_TRUE(IsOpen()) << path;
  }
  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }
  bool IsOpen() const { return driver_.Has("menu/window/0"); }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(MenusStory, ARightClickOnANodeDisablesIt) {
  RightClick("canvas/MainTree/1.1.2");
  EXPECT_EQ(driver_.Selected(), "1.1.2");
  EXPECT_EQ(CompareWithReference(driver_.editor.Picture(), "story_menu_of_a_node"), "");
  ASSERT_TRUE(driver_.Click("menu/edit.disable"));
  EXPECT_NE(Text().find("_skipIf"), std::string::npos);
  EXPECT_FALSE(IsOpen());
}

TEST_F(MenusStory, ARightClickOnALinePutsANodeBetween) {
  const Box parent = driver_.BoxOf("canvas/MainTree/1.1");
  const Box child = driver_.BoxOf("canvas/MainTree/1.1.2");
  driver_.ClickAt({child.center().x, (parent.max.y + child.min.y) / 2 + 4}, 1);
  if (!driver_.Has("menu/edit.add_around")) driver_.ClickAt({child.center().x, child.min.y - 5}, 1);
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("menu/edit.add_around"));
  driver_.Type("Inverter");
  driver_.Press(kKeyEnter);
  const std::size_t inserted = Text().rfind("<Inverter>");
  ASSERT_NE(inserted, std::string::npos);
  EXPECT_LT(inserted, Text().find("<SwitchOn"));
  EXPECT_GT(inserted, Text().find("<IsDark"));
}

TEST_F(MenusStory, ARightClickOnTheEmptyCanvasAddsANode) {
  const Box canvas = driver_.BoxOf("canvas");
  driver_.ClickAt(canvas.min + Point{12, canvas.height() - 12}, 1);
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("menu/edit.add"));
  EXPECT_EQ(driver_.editor.state().popup.kind, Popup::kAdd);
}

TEST_F(MenusStory, ARightClickThatDragsMovesTheCanvasAndOpensNothing) {
  const Point at = driver_.BoxOf("canvas/MainTree/1").center();
  driver_.Drag(at, at + Point{40, 30}, 1);
  driver_.Frames();
  const Point way = driver_.BoxOf("canvas/MainTree/1").center() - at;
  EXPECT_NEAR(way.x, 40, 1);
  EXPECT_NEAR(way.y, 30, 1);
  EXPECT_FALSE(IsOpen());
}

TEST_F(MenusStory, ARightClickOnARowOfTheOutlineDeletesItsNode) {
  RightClick("outline/1.3");
  ASSERT_TRUE(driver_.Click("menu/edit.delete"));
  EXPECT_EQ(Text().find("<AlwaysSuccess/>"), std::string::npos);
}

TEST_F(MenusStory, ARightClickOnATreeRenamesIt) {
  RightClick("project/small.xml/Walk");
  ASSERT_TRUE(driver_.Click("menu/tree.rename"));
  driver_.Type("Stroll");
  driver_.Press(kKeyEnter);
  EXPECT_NE(Text().find(R"(<BehaviorTree ID="Stroll">)"), std::string::npos);
}

TEST_F(MenusStory, ARightClickOnATabClosesTheOthers) {
  driver_.Click("project/small.xml/Walk");
  driver_.Frames(20);
  RightClick("canvasbar/tab/MainTree");
  ASSERT_TRUE(driver_.Click("menu/tab.close_others"));
  EXPECT_EQ(driver_.editor.state().canvas.tabs.size(), 1U);
  EXPECT_EQ(driver_.editor.state().workspace.ShownTreeId(), "MainTree");
}

TEST_F(MenusStory, WhatCannotBeDoneIsGreyAndSaysWhy) {
  RightClick("canvas/MainTree/1.1.2");
  driver_.MoveTo(driver_.BoxOf("menu/tree.definition").center());
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("menu/why_not"));
  EXPECT_EQ(driver_.editor.state().commands.Find("tree.definition")->WhyNot(),
            "the node is not a SubTree");
  driver_.Click("menu/tree.definition");
  EXPECT_TRUE(IsOpen()) << "nothing was done";
}

TEST_F(MenusStory, TheMenuKeyOpensItAtTheSelectionAndArrowsWalkInIt) {
  driver_.Click("canvas/MainTree/1.1.2");
  driver_.Press(kKeyMenu);
  ASSERT_TRUE(IsOpen());
  driver_.Press('C');
  driver_.Press('C');  // "Change type", "Cut"
  driver_.Press(kKeyDown);
  driver_.Press(kKeyEnter);
  EXPECT_NE(driver_.editor.state().services.get_clipboard().find("<SwitchOn"), std::string::npos);
  ASSERT_FALSE(IsOpen());
  driver_.Press(kKeyF1 + 9, kShift);
  EXPECT_TRUE(IsOpen());
}

TEST_F(MenusStory, EscClosesTheMenuAndNothingElse) {
  driver_.Click("canvas/MainTree/1.1.2");
  driver_.Press(kKeyMenu);
  ASSERT_TRUE(IsOpen());
  driver_.Press(kKeyEscape);
  EXPECT_FALSE(IsOpen());
  EXPECT_EQ(driver_.Selected(), "1.1.2") << "Esc selects nothing only when no menu is open";
  driver_.Press(kKeyEscape);
  EXPECT_EQ(driver_.Selected(), "");
}

TEST_F(MenusStory, AltOpensTheMenusOfTheBarAndArrowsWalkThem) {
  driver_.Press(kKeyLeftAlt);
  ASSERT_TRUE(driver_.Has("menu/file.open"));
  driver_.Press(kKeyRight);
  EXPECT_TRUE(driver_.Has("menu/edit.undo"));
  driver_.Press(kKeyLeft);
  driver_.Press(kKeyLeft);
  EXPECT_TRUE(driver_.Has("menu/help.keys")) << "round the end";
  driver_.Press(kKeyLeftAlt);
  ASSERT_FALSE(IsOpen());
  driver_.Press(kKeyF1 + 9);
  EXPECT_TRUE(driver_.Has("menu/file.open"));
}

TEST_F(MenusStory, AltWithAnotherKeyOpensNoMenu) {
  driver_.input.events = {KeyEvent{kKeyLeftAlt, true, kAlt}, KeyEvent{'X', true, kAlt},
                          KeyEvent{'X', false, kAlt}, KeyEvent{kKeyLeftAlt, false, kNoModifier}};
  driver_.Frames(4);
  EXPECT_FALSE(IsOpen());
}

TEST_F(MenusStory, TheMouseOnAnotherTitleOpensItsMenu) {
  driver_.Click("menu/file");
  ASSERT_FALSE(driver_.Has("menu/edit.undo"));
  driver_.MoveTo(driver_.BoxOf("menu/edit").center());
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("menu/edit.undo"));
}

TEST_F(MenusStory, AClickBesideTheMenuClosesItAndDoesNothingElse) {
  RightClick("canvas/MainTree/1.1.2");
  driver_.Click("project/small.xml/Walk");
  EXPECT_FALSE(IsOpen());
  EXPECT_EQ(driver_.editor.state().workspace.ShownTreeId(), "MainTree");
}

TEST(MenusOfARunStory, ARightClickOnAKeyWritesIt) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Write("Main", "goal", "kitchen");
  driver.Frames(4);
  ASSERT_TRUE(driver.Has("blackboard/Main/goal"));
  driver.ClickAt(driver.BoxOf("blackboard/Main/goal").center(), 1);
  driver.Frames();
  ASSERT_TRUE(driver.Click("menu/blackboard.write"));
  EXPECT_EQ(driver.editor.state().popup.kind, Popup::kPrompt);
}

TEST_F(MenusStory, WhileASimulationIsShownF10TicksAndAltOpensTheMenus) {
  driver_.Press(kKeyF1 + 4);
  driver_.Frames(4);
  ASSERT_NE(driver_.editor.state().workspace.run(), nullptr);
  const std::size_t before = driver_.editor.state().workspace.run()->run().size();
  driver_.Press(kKeyF1 + 9);
  driver_.Frames(4);
  EXPECT_EQ(driver_.editor.state().workspace.run()->run().size(), before + 1);
  EXPECT_FALSE(IsOpen());
  driver_.Press(kKeyLeftAlt);
  ASSERT_TRUE(driver_.Has("menu/file.open"));
  driver_.Press(kKeyF1 + 9);
  EXPECT_EQ(driver_.editor.state().workspace.run()->run().size(), before + 1)
      << "the keys are the menu's";
}

TEST(MenusOfARunStory, OnARobotF10TicksAndOpensNoMenu) {
  Driver driver;
  const ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  driver.Frames(4);
  driver.Press(kKeyF1 + 9);
  ASSERT_FALSE(robot->commands.empty());
  EXPECT_EQ(robot->commands.back().kind, LiveCommand::Kind::kStepTick);
  EXPECT_FALSE(driver.Has("menu/window/0"));
}

// Of the node "Drive", which runs.
class MenuOfALaneStory : public testing::Test {
 protected:
  MenuOfALaneStory() {
    AddExecuted(driver_, "robot:1", 20);
    driver_.Frames(4);
    const Box lane = driver_.BoxOf("timeline/pass/Drive");
    driver_.ClickAt({lane.min.x + lane.width() / 3, lane.center().y}, 1);
    driver_.Frames();
  }
  Driver driver_;
};

TEST_F(MenuOfALaneStory, SelectsItsNodeAndPinsItsLane) {
  EXPECT_EQ(driver_.Selected(), "1.2.1");
  driver_.Picture("menu_of_a_lane");
  ASSERT_TRUE(driver_.Click("menu/run.pin"));
  EXPECT_TRUE(driver_.editor.state().workspace.pins.Has("robot:1", "pass/Drive"));
}

TEST_F(MenuOfALaneStory, SetsABreakpoint) {
  ASSERT_TRUE(driver_.Click("menu/run.breakpoint"));
  const HookList& hooks = driver_.editor.state().workspace.hooks;
  ASSERT_EQ(hooks.all().size(), 1U);
  EXPECT_EQ(hooks.all()[0].hook.path, "pass/Drive");
}

TEST_F(MenuOfALaneStory, ShowsTheStatistics) {
  ASSERT_NE(driver_.editor.state().run.tab, RunTab::kStatistics);
  ASSERT_TRUE(driver_.Click("menu/run.statistics"));
  EXPECT_EQ(driver_.editor.state().run.tab, RunTab::kStatistics);
}

}  // namespace
}  // namespace coppice::editor
