#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunStatistics, HasALineForEveryNodeAndLeadsThere) {
  Driver driver;
  AddExecuted(driver, "robot:1", 20);
  driver.Press('S');
  EXPECT_TRUE(driver.Has("run/figures/all"));
  ASSERT_TRUE(driver.Click("run/figures/IsDoorOpen"));
  EXPECT_EQ(driver.Selected(), "1.1.1");
  driver.Picture("statistics");
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
