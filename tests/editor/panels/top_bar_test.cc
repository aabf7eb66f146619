#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(TopBar, RunsCommandsFromItsMenus) {
  Driver driver;
  driver.Frames();
  ASSERT_TRUE(driver.Click("menu/view"));
  ASSERT_TRUE(driver.Click("menu/palette.light"));
  EXPECT_EQ(driver.editor.state().screen.palette, PaletteName::kLight);
  ASSERT_TRUE(driver.Click("menu/tiles"));
  ASSERT_TRUE(driver.Click("menu/tile.outline"));
  EXPECT_FALSE(driver.Has("outline"));
  ASSERT_TRUE(driver.Click("menu/file"));
  driver.Picture("menu");
  ASSERT_TRUE(driver.Click("menu/file.open"));
  EXPECT_TRUE(driver.Has("popup/input"));
}

TEST(TopBar, OpensTheCommandPalette) {
  Driver driver;
  driver.Frames();
  ASSERT_TRUE(driver.Click("bar/palette"));
  EXPECT_TRUE(driver.Has("popup/0"));
}

TEST(TopBar, ShowsGreenWhileLive) {
  Driver driver;
  driver.Frames();
  const Palette& colors = GetPalette(PaletteName::kDark);
  const Color green = Mix(colors.panel, colors.success, 0.55F);
  EXPECT_EQ(driver.CountColor(driver.BoxOf("bar/mode"), green, 6), 0);
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  EXPECT_GT(driver.CountColor(driver.BoxOf("bar/mode"), green, 6), 300);
  robot->Disconnect("no answer");
  driver.Frames();
  EXPECT_EQ(driver.CountColor(driver.BoxOf("bar/mode"), green, 6), 0);
}

}  // namespace
}  // namespace coppice::editor
