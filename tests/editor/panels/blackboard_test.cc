#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Blackboard, ShowsTheValuesOfEveryScope) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Write("Main", "goal", "kitchen");
  robot->Write("Main", "level", "7");
  robot->Write("walk", "n", "1");
  driver.Frames();
  for (const char* path :
       {"blackboard/Main", "blackboard/Main/goal", "blackboard/Main/level", "blackboard/walk/n"}) {
    EXPECT_TRUE(driver.Has(path)) << path;
  }
}

TEST(Blackboard, FlashesAValueThatChanges) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Write("Main", "goal", "1");
  robot->Tick();
  driver.Frames(3);
  const Box row = driver.BoxOf("blackboard/Main/goal");
  const Color panel = GetPalette(PaletteName::kDark).panel;
  const int calm = driver.CountColor(row, panel, 2);
  robot->Write("Main", "goal", "2");
  driver.Frames(1);
  EXPECT_LT(driver.CountColor(row, panel, 2), calm / 4);
  driver.Frames(80);
  EXPECT_GT(driver.CountColor(row, panel, 2), calm * 3 / 4);
}

TEST(Blackboard, MarksTheKeysOfTheSelectedNode) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Write("Main", "goal", "1");
  robot->Write("Main", "other", "1");
  driver.Frames(3);
  ASSERT_TRUE(driver.Click("canvas/Main/1.2"));
  const Color marked = GetPalette(PaletteName::kDark).accent;
  EXPECT_GT(driver.CountColor(driver.BoxOf("blackboard/Main/goal"), marked, 2), 40);
  EXPECT_EQ(driver.CountColor(driver.BoxOf("blackboard/Main/other"), marked, 2), 0);
}

TEST(Blackboard, TheWritesOfTheClickedKeyStandBelowIt) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Write("Main", "goal", "1");
  robot->Write("Main", "other", "1");
  robot->Write("Main", "goal", "2");
  driver.Frames(3);
  ASSERT_TRUE(driver.Click("blackboard/Main/goal"));
  driver.Frames();
  ASSERT_TRUE(driver.Has("blackboard/write/0"));
  const float write = driver.BoxOf("blackboard/write/0").min.y;
  EXPECT_GT(write, driver.BoxOf("blackboard/Main/goal").min.y);
  EXPECT_LT(write, driver.BoxOf("blackboard/Main/other").min.y);
}

}  // namespace
}  // namespace coppice::editor
