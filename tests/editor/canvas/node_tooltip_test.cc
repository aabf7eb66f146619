#include "editor/canvas/node_tooltip.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(NodeTooltip, AppearsBesideTheMouseAndGoesAway) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  const Box canvas = driver.BoxOf("canvas");
  driver.MoveTo({canvas.min.x + 8, canvas.max.y - 8});
  driver.Frames(4);
  const Box node = driver.BoxOf("canvas/MainTree/1.1.2");
  const Box beside = {node.center() + Point{20, 20}, node.center() + Point{220, 90}};
  const Color panel = GetPalette(PaletteName::kDark).panel;
  const int before = driver.CountColor(beside, panel, 2);
  driver.MoveTo(node.center());
  driver.Frames(4);
  EXPECT_GT(driver.CountColor(beside, panel, 2), before + 3000);
  driver.Picture("tooltip");
  driver.Press(kKeyTab);  // who types sees the tree
  driver.Frames(4);
  EXPECT_EQ(driver.CountColor(beside, panel, 2), before);
  driver.Press(kKeyEscape);
  driver.MoveTo(node.center() + Point{1, 0});
  driver.Frames(4);
  EXPECT_GT(driver.CountColor(beside, panel, 2), before + 3000);
  driver.MoveTo({canvas.min.x + 8, canvas.max.y - 8});
  driver.Frames(4);
  EXPECT_EQ(driver.CountColor(beside, panel, 2), before);
}

}  // namespace
}  // namespace coppice::editor
