#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(ConnectionStrip, HasATabForEachRobotAndSwitchesByClick) {
  Driver driver;
  driver.AddRobot("one:1", kLiveTree);
  driver.AddRobot("two:2", kLiveTree);
  ASSERT_TRUE(driver.Click("strip/one:1"));
  EXPECT_EQ(driver.editor.state().workspace.run()->name(), "one:1");
  ASSERT_TRUE(driver.Click("strip/two:2"));
  EXPECT_EQ(driver.editor.state().workspace.run()->name(), "two:2");
}

TEST(ConnectionStrip, ShowsTheStateInColour) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("one:1", kLiveTree);
  const Color green = GetPalette(PaletteName::kDark).success;
  driver.Frames();
  EXPECT_GT(driver.CountColor(driver.BoxOf("strip/one:1"), green), 30);
  robot->Disconnect("no answer");
  driver.Frames();
  EXPECT_EQ(driver.CountColor(driver.BoxOf("strip/one:1"), green), 0);
}

TEST(ConnectionStrip, IsNotAmberWhileTheRobotStandsForThatIsWhatRuns) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("one:1", kLiveTree);
  driver.Frames();
  robot->Stop(NodeIndex(0));
  driver.Frames();
  driver.Picture("strip_paused");
  ASSERT_TRUE(driver.Has("strip/stopped"));
  const Color amber = GetPalette(PaletteName::kDark).running;
  for (const char* path : {"strip", "bar/mode"}) {
    EXPECT_EQ(driver.CountColor(driver.BoxOf(path), amber, 60), 0) << path;
  }
}

TEST(ConnectionStrip, AsksWhereToConnect) {
  Driver driver;
  driver.Frames();
  ASSERT_TRUE(driver.Click("bar/connect"));
  EXPECT_TRUE(driver.Has("popup/input"));
  driver.Press(kKeyEscape);
  EXPECT_FALSE(driver.Has("popup/input"));
}

}  // namespace
}  // namespace coppice::editor
