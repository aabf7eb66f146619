#include <gtest/gtest.h>

#include "editor/canvas/canvas.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Minimap, MovesTheCameraToWhereItIsClicked) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  driver.view().ZoomAt({0, 0}, 2);
  driver.Frames();
  const Box map = driver.BoxOf("canvas/minimap");
  ASSERT_GT(map.width(), 50);
  driver.ClickAt({map.min.x + 12, map.center().y});
  const float left = driver.view().camera.offset.x;
  driver.ClickAt({map.max.x - 12, map.center().y});
  EXPECT_LT(driver.view().camera.offset.x, left - 50);
}

TEST(Minimap, CanBeHidden) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  driver.view().ZoomAt({0, 0}, 3);
  driver.Frames();
  EXPECT_TRUE(driver.Has("canvas/minimap"));
  driver.Press(kKeyF1 + 10);
  EXPECT_FALSE(driver.Has("canvas/minimap"));
}

TEST(Minimap, IsNotThereWhenTheWholeTreeIsInSight) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  driver.Press(kKeyHome);
  driver.Frames(12);
  EXPECT_FALSE(driver.Has("canvas/minimap"));
  driver.view().ZoomAt({0, 0}, 3);
  driver.Frames();
  EXPECT_TRUE(driver.Has("canvas/minimap"));
}

}  // namespace
}  // namespace coppice::editor
