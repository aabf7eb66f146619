#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(TypePalette, ListsTypesByKindAndAddsWithADoubleClick) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_TRUE(driver.Has("types/heading/Control"));
  driver.view().Select(driver.view().scene()->FindPath("1.1"));
  ASSERT_TRUE(driver.Click("types/filter"));
  driver.Type("SwitchOn");
  ASSERT_TRUE(driver.Has("types/SwitchOn"));
  EXPECT_FALSE(driver.Has("types/Sequence"));
  const Point at = driver.BoxOf("types/SwitchOn").center();
  driver.ClickAt(at);
  driver.ClickAt(at);
  EXPECT_EQ(driver.Selected(), "1.1.3");
  driver.Picture("types");
}

TEST(TypePalette, IsEmptyWithoutAFile) {
  Driver driver;
  driver.Frames();
  EXPECT_FALSE(driver.Has("types/filter"));
}

}  // namespace
}  // namespace coppice::editor
