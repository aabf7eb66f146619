#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Inspector, ShowsPortsInDeclaredOrderAndThoseNotGiven) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_FALSE(driver.Has("inspector/name"));
  ASSERT_TRUE(driver.Click("canvas/MainTree/1.1.2"));
  for (const char* path : {"inspector/name", "inspector/type", "inspector/path", "inspector/source",
                           "inspector/model"}) {
    EXPECT_TRUE(driver.Has(path)) << path;
  }
  const float level = driver.BoxOf("inspector/port/level").min.y;
  const float lamp = driver.BoxOf("inspector/port/lamp").min.y;
  const float slowly = driver.BoxOf("inspector/port/slowly").min.y;
  EXPECT_LT(level, lamp);
  EXPECT_LT(lamp, slowly);
  driver.Picture("inspector");
}

TEST(Inspector, ShowsTheStatusOfARobotsNode) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Set(6, Status::kRunning);
  driver.Frames();
  ASSERT_TRUE(driver.Click("canvas/Main/1.3"));
  ASSERT_TRUE(driver.Has("inspector/status"));
  EXPECT_GT(driver.CountColor(driver.BoxOf("inspector/status"),
                              GetPalette(PaletteName::kDark).running, 40),
            20);
}

}  // namespace
}  // namespace coppice::editor
