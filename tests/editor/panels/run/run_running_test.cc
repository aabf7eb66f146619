#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunRunning, ListsTheLeavesThatRunAndLeadsToThem) {
  Driver driver;
  AddExecuted(driver, "robot:1", 10);
  driver.Press('N');
  ASSERT_TRUE(driver.Click("run/running/pass/Drive"));
  EXPECT_EQ(driver.Selected(), "1.2.1");
  EXPECT_FALSE(driver.Has("run/running/mission")) << "leaves only";
}

}  // namespace
}  // namespace coppice::editor
