#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunComparison, ShowsWhereTwoRunsPartAndGoesThere) {
  Driver driver;
  ASSERT_TRUE(ComparePartingRuns(driver));
  ASSERT_TRUE(driver.Click("run/parting"));
  EXPECT_EQ(driver.editor.state().workspace.run()->playhead().tick(), 12U);
  EXPECT_TRUE(driver.Has("run/difference/0"));
  driver.Picture("comparison");
}

}  // namespace
}  // namespace coppice::editor
