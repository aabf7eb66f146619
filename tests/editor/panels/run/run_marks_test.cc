#include "editor/panels/run/run_marks.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunMarks, AreThereWhenTheyAreWanted) {
  Driver driver;
  AddExecuted(driver, "robot:1", 20);
  EditorState& state = driver.editor.state();
  EXPECT_TRUE(RunHeat(state, driver.view()).values.empty());
  state.heat = HeatMode::kNeverTicked;
  EXPECT_EQ(RunHeat(state, driver.view()).values.size(), driver.view().scene()->nodes.size());
  EXPECT_TRUE(RunDifferences(state, driver.view()).empty());
  RunComparison result;
  result.differences.push_back({"pass/Drive", 1, 1, "", ""});
  state.comparison = {"robot:1", "other", result};
  const std::vector<Change> changes = RunDifferences(state, driver.view());
  EXPECT_EQ(changes[driver.view().scene()->FindPath("1.2.1")], Change::kChanged);
  EXPECT_EQ(changes[0], Change::kNone);
}

}  // namespace
}  // namespace coppice::editor
