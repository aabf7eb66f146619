#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(CanvasBar, TurnsTheTreeAndFitsIt) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  ASSERT_TRUE(driver.Click("canvasbar/lr"));
  driver.Frames(15);
  EXPECT_GT(driver.BoxOf("canvas/MainTree/1.1").min.x, driver.BoxOf("canvas/MainTree/1").max.x);
  driver.Picture("left_to_right");
  ASSERT_TRUE(driver.Click("canvasbar/tb"));
  driver.Frames(15);
  EXPECT_GT(driver.BoxOf("canvas/MainTree/1.1").min.y, driver.BoxOf("canvas/MainTree/1").max.y);
  const float zoom = driver.view().camera.zoom;
  driver.view().camera = {{-4000, 0}, 0.1F};
  ASSERT_TRUE(driver.Click("canvasbar/fit"));
  EXPECT_NEAR(driver.view().camera.zoom, zoom, 0.01);
}

}  // namespace
}  // namespace coppice::editor
