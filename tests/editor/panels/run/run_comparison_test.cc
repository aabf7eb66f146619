#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunComparison, ShowsWhereTwoRunsPartAndGoesThere) {
  Driver driver;
  AddExecuted(driver, "a.coppice", 20, false);
  auto other = std::make_unique<ExecutedSource>("b.coppice", kDoorTrees, false);
  other->tree.results["drive"] = Status::kRunning;
  other->Ticks(12);
  other->tree.results["drive"] = Status::kFailure;
  other->Ticks(8);
  driver.editor.AddRun(std::move(other));
  driver.Frames();
  driver.editor.state().run.tab = RunTab::kComparison;
  driver.Frames();
  ASSERT_TRUE(driver.Click("run/compare/a.coppice"));
  driver.Frames();
  ASSERT_TRUE(driver.Click("run/parting"));
  EXPECT_EQ(driver.editor.state().workspace.run()->playhead().tick(), 12U);
  EXPECT_TRUE(driver.Has("run/difference/0"));
  driver.Picture("comparison");
}

}  // namespace
}  // namespace coppice::editor
