#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Blackboard, ShowsTheValuesOfEveryScope) {
  Driver driver;
  const auto robot = driver.AddRobot("robot:1", kLiveTree);
  robot->boards = {{"Main", {{"goal", "\"kitchen\""}, {"level", "7"}}}, {"walk", {{"n", "null"}}}};
  driver.Frames();
  for (const char* path :
       {"blackboard/Main", "blackboard/Main/goal", "blackboard/Main/level", "blackboard/walk/n"}) {
    EXPECT_TRUE(driver.Has(path)) << path;
  }
}

TEST(Blackboard, FlashesAValueThatChanges) {
  Driver driver;
  const auto robot = driver.AddRobot("robot:1", kLiveTree);
  robot->boards = {{"Main", {{"goal", "1"}}}};
  driver.Frames(3);
  const Box row = driver.BoxOf("blackboard/Main/goal");
  const Color panel = GetPalette(PaletteName::kDark).panel;
  const int calm = driver.CountColor(row, panel, 2);
  robot->boards = {{"Main", {{"goal", "2"}}}};
  driver.Frames(1);
  EXPECT_LT(driver.CountColor(row, panel, 2), calm / 4);
  driver.Frames(80);
  EXPECT_GT(driver.CountColor(row, panel, 2), calm * 3 / 4);
}

TEST(Blackboard, MarksTheKeysOfTheSelectedNode) {
  Driver driver;
  const auto robot = driver.AddRobot("robot:1", kLiveTree);
  robot->boards = {{"Main", {{"goal", "1"}, {"other", "1"}}}};
  driver.Frames(3);
  ASSERT_TRUE(driver.Click("canvas/Main/1.2"));
  const Color marked = GetPalette(PaletteName::kDark).row_selected;
  EXPECT_GT(driver.CountColor(driver.BoxOf("blackboard/Main/goal"), marked, 2), 1000);
  EXPECT_EQ(driver.CountColor(driver.BoxOf("blackboard/Main/other"), marked, 2), 0);
}

}  // namespace
}  // namespace coppice::editor
