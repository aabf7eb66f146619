#include <gtest/gtest.h>

#include "bt_core/frames/pause_note.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

using std::chrono::milliseconds;

TEST(RunStatistics, HasALineForEveryNodeAndLeadsThere) {
  Driver driver;
  AddExecuted(driver, "robot:1", 20);
  driver.Press('S');
  EXPECT_TRUE(driver.Has("run/figures/all"));
  ASSERT_TRUE(driver.Click("run/figures/IsDoorOpen"));
  EXPECT_EQ(driver.Selected(), "1.1.1");
  driver.Picture("statistics");
}

TEST(RunStatistics, AreReadWithPausesToo) {
  Driver driver;
  ExecutedSource* const robot = AddExecuted(driver, "robot:1", 20);
  const coppice::editor::Run& run = driver.editor.state().workspace.run()->run();
  const Time from = run.recording().ticks()[2].start;
  robot->Note(NoteOf(Pause{from, from + milliseconds(600)}));
  robot->StopBefore(NodeIndex{5});
  driver.Press('S');
  driver.Frames(4);
  EXPECT_EQ(driver.editor.state().run.figures.statistics().paused, milliseconds(600));
  driver.Picture("statistics_with_pauses");
}

TEST(RunStatistics, PaintHeatOnTheCanvas) {
  Driver driver;
  AddExecuted(driver, "robot:1", 20);
  driver.Press('H');
  ASSERT_TRUE(driver.editor.state().run.heat);
  EXPECT_EQ(*driver.editor.state().run.heat, HeatMode::kTime);
  driver.Frames(10);
  driver.Picture("heat");
  for (int i = 0; i < 4; ++i) driver.Press('H');
  EXPECT_FALSE(driver.editor.state().run.heat);
}

}  // namespace
}  // namespace coppice::editor
