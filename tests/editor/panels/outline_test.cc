#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Outline, HasARowPerVisibleNodeInOrder) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  float last = 0;
  for (const char* path : {"1", "1.1", "1.1.1", "1.1.1.1", "1.1.2", "1.2", "1.2.1"}) {
    ASSERT_TRUE(driver.Has(std::string("outline/") + path)) << path;
    const float y = driver.BoxOf(std::string("outline/") + path).min.y;
    EXPECT_GT(y, last);
    last = y;
  }
}

TEST(Outline, SelectsByClickAndBringsTheNodeIntoView) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.view().camera.offset = {4000, 0};
  driver.Frames();
  EXPECT_FALSE(driver.Has("canvas/MainTree/1.1.2"));
  ASSERT_TRUE(driver.Click("outline/1.1.2"));
  EXPECT_EQ(driver.Selected(), "1.1.2");
  EXPECT_TRUE(driver.Has("canvas/MainTree/1.1.2"));
}

TEST(Outline, TintsRowsByStatus) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Set(6, Status::kFailure);
  driver.Frames();
  const Box row = driver.BoxOf("outline/1.3");
  const Box stripe = {row.min, {row.min.x + 4, row.max.y}};
  EXPECT_GT(driver.CountColor(stripe, GetPalette(PaletteName::kDark).failure, 4), 50);
}

TEST(Outline, ScrollsToTheSelection) {
  std::string xml = R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence>)";
  for (int i = 0; i < 300; ++i) xml += "<AlwaysSuccess/>";
  const TemporaryFile file("long.xml", xml + "</Sequence></BehaviorTree></root>");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_FALSE(driver.Has("outline/1.250"));
  driver.view().Select(driver.view().scene()->FindPath("1.250"));
  driver.Frames();
  EXPECT_TRUE(driver.Has("outline/1.250"));
}

}  // namespace
}  // namespace coppice::editor
