#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(StopBar, StandsBelowTheNodeAndForcesAResult) {
  Driver driver;
  ExecutedSource* robot = AddExecuted(driver, "robot:1", 10);
  EXPECT_FALSE(driver.Has("stop/continue"));
  robot->StopBefore(NodeIndex{1});
  driver.Frames();
  EXPECT_TRUE(driver.Has("strip/stopped"));
  EXPECT_GT(driver.BoxOf("stop/continue").min.y, driver.BoxOf("canvas/Main/1.1").max.y);
  driver.Picture("stopped");
  ASSERT_TRUE(driver.Click("stop/failure"));
  ASSERT_FALSE(robot->commands.empty());
  EXPECT_EQ(robot->commands.back().kind, LiveCommand::Kind::kContinue);
  EXPECT_EQ(robot->commands.back().result, Status::kFailure);
}

}  // namespace
}  // namespace coppice::editor
