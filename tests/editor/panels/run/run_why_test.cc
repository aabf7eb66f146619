#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunWhy, ShowsTheWalkToTheSelectedNodeAndLeadsThere) {
  Driver driver;
  ExecutedSource* robot = AddExecuted(driver, "robot:1", 5);
  robot->tree.results["drive"] = Status::kFailure;
  robot->Ticks(1);
  driver.Frames();
  EXPECT_TRUE(driver.Has("run/why/change"));
  EXPECT_TRUE(driver.Has("run/why/1"));
  ASSERT_TRUE(driver.Click("canvas/Main/1.1.2"));
  EXPECT_TRUE(driver.Has("run/why/not")) << "the door was open, so it was not opened";
  ASSERT_TRUE(driver.Click("run/why/0"));
  EXPECT_EQ(driver.Selected(), "1");
  driver.Picture("why");
}

}  // namespace
}  // namespace coppice::editor
