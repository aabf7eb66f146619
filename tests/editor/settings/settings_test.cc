#include "editor/settings/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

TEST(Settings, AreTheSameAfterWritingAndReading) {
  Settings settings;
  settings.palette = PaletteName::kColourBlind;
  settings.reduce_motion = true;
  settings.scale = 1.25F;
  settings.wheel_zooms = true;
  settings.finds_robots = false;
  settings.tiles.xml = false;
  settings.splits.left = 333.5F;
  settings.style.growth = Growth::kAcross;
  settings.style.compact = true;
  settings.style.ports = ShownPorts::kNone;
  settings.width = 1600;
  Diagnostics diagnostics;
  const Settings read = ReadSettings(WriteSettings(settings), "s.json", diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  EXPECT_EQ(WriteSettings(read), WriteSettings(settings));
  EXPECT_EQ(read.splits.left, 333.5F);
  EXPECT_EQ(read.scale, 1.25F);
  EXPECT_TRUE(read.wheel_zooms);
  EXPECT_FALSE(read.finds_robots);
  EXPECT_TRUE(read.style == settings.style);
  EXPECT_EQ(read.palette, PaletteName::kColourBlind);
}

TEST(Settings, WhatCannotBeRightIsSaidAndTheRestHolds) {
  Diagnostics diagnostics;
  const Settings settings = ReadSettings(
      "{\"palette\": \"pink\",\n \"tiles\": {\"xml\": 3, \"outline\": false},\n"
      " \"window\": {\"width\": 1e9, \"height\": 500}, \"of another version\": []}",
      "s.json", diagnostics);
  EXPECT_EQ(settings.palette, PaletteName::kDark);
  EXPECT_TRUE(settings.tiles.xml);
  EXPECT_FALSE(settings.tiles.outline);
  EXPECT_EQ(settings.width, 1280);
  EXPECT_EQ(settings.height, 500);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("s.json:1:"));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("\"xml\" is not true or false"));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("\"width\""));
}

TEST(Settings, NonsenseIsAsANewEditor) {
  for (const char* text : {"", "[]", "{", "3", "{\"tiles\": 3, \"sizes\": []}"}) {
    Diagnostics diagnostics;
    EXPECT_EQ(WriteSettings(ReadSettings(text, "s.json", diagnostics)), WriteSettings({})) << text;
  }
}

TEST(Settings, WhatWasSaidForThisTimeIsNotKept) {
  const TemporaryFolder folder;
  EditorOptions options;
  options.settings_file = folder.Path("settings.json");
  options.settings.palette = PaletteName::kLight;  // as --palette light
  {
    Driver driver(options);
    driver.editor.state().commands.Run("tile.outline");
    driver.Frames();
    driver.input.width = driver.input.height = 1;  // an icon
    driver.Frames();
  }
  Diagnostics diagnostics;
  const Settings kept = ReadSettings(ReadFile(options.settings_file), "", diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  EXPECT_FALSE(kept.tiles.outline);
  EXPECT_EQ(kept.palette, PaletteName::kDark);
  EXPECT_EQ(kept.width, 1280);
}

TEST(Settings, AreThereAgainTheNextTime) {
  const TemporaryFolder folder;
  EditorOptions options;
  options.settings_file = folder.Path("config/settings.json");
  {
    Driver driver(options);
    driver.input.width = 1000;
    driver.editor.state().commands.Run("palette.light");
    driver.editor.state().commands.Run("tile.outline");
    driver.Frames();
  }
  Diagnostics diagnostics;
  options.settings = options.kept_settings =
      ReadSettings(ReadFile(options.settings_file), "", diagnostics);
  EXPECT_EQ(options.settings.width, 1000);
  Driver driver(options);
  driver.Frames();
  EXPECT_EQ(driver.editor.state().screen.palette, PaletteName::kLight);
  EXPECT_FALSE(driver.Has("outline"));
}

}  // namespace
}  // namespace coppice::editor
