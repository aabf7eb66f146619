#include "editor/panels/canvas_tile.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/driver.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(CanvasTile, ProblemsAreBadgesOfTheirNodesAndGoWithThem) {
  const TemporaryFile file("t.xml",
                           "<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence>\n"
                           "<AlwaysSuccess/>\n<Inverter/>\n</Sequence></BehaviorTree></root>");
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames(10);
  const std::vector<Badge>& badges = driver.editor.state().canvas.badges.by_node;
  ASSERT_EQ(badges.size(), 3U);
  EXPECT_EQ(badges[1], Badge::kNone);
  EXPECT_EQ(badges[2], Badge::kError) << "an Inverter needs a child";
  driver.view().Select(2);
  driver.editor.state().commands.Run("edit.delete");
  driver.Frames(10);
  EXPECT_EQ(std::count(badges.begin(), badges.end(), Badge::kError), 0);
}

TEST(CanvasTile, WhatARobotRunsCannotBeDragged) {
  Driver driver;
  driver.AddRobot("robot:1", kLiveTree);
  driver.Frames(5);
  const std::string before = driver.view().scene()->nodes[1].path;
  driver.Drag(driver.BoxOf("canvas/Main/1.1").center(), driver.BoxOf("canvas/Main/1.3").center());
  EXPECT_FALSE(driver.Has("canvas/ghost"));
  EXPECT_EQ(driver.view().scene()->nodes[1].path, before);
}

TEST(RunMarks, AreThereWhenTheyAreWanted) {
  Driver driver;
  AddExecuted(driver, "robot:1", 20);
  EditorState& state = driver.editor.state();
  EXPECT_TRUE(RunHeat(state, driver.view()).values.empty());
  state.run.heat = HeatMode::kNeverTicked;
  EXPECT_EQ(RunHeat(state, driver.view()).values.size(), driver.view().scene()->nodes.size());
  EXPECT_TRUE(RunDifferences(state, driver.view()).empty());
  RunComparison result;
  result.differences.push_back({"pass/Drive", 1, 1, "", ""});
  state.run.comparison = {"robot:1", "other", result, {}};
  const std::vector<Change> changes = RunDifferences(state, driver.view());
  EXPECT_EQ(changes[driver.view().scene()->FindPath("1.2.1")], Change::kChanged);
  EXPECT_EQ(changes[0], Change::kNone);
}

}  // namespace
}  // namespace coppice::editor
