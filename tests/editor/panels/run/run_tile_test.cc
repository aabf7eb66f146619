#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunTile, ChangesItsTabByClickAndByKey) {
  Driver driver;
  AddExecuted(driver, "robot:1", 10);
  EXPECT_TRUE(driver.Has("run/why/0"));
  ASSERT_TRUE(driver.Click("run/running"));
  EXPECT_TRUE(driver.Has("run/running/pass/Drive"));
  driver.Press('W');
  EXPECT_EQ(driver.editor.state().run.tab, RunTab::kWhy);
  driver.Press(kKeyF1 + 7, kShift);
  EXPECT_FALSE(driver.Has("run"));
}

TEST(RunTile, StandsAsideForTheProblemsOfFiles) {
  Driver driver;
  driver.Frames();
  EXPECT_FALSE(driver.Has("run"));
  EXPECT_TRUE(driver.Has("problems"));
}

}  // namespace
}  // namespace coppice::editor
