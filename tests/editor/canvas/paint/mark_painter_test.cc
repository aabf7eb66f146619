#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(MarkPainter, PaintsBreakpointsFaultsAndWhereTheTreeStands) {
  Driver driver;
  ExecutedSource* robot = AddExecuted(driver, "robot:1", 10);
  const Palette& colors = GetPalette(PaletteName::kDark);
  ASSERT_TRUE(driver.Click("canvas/Main/1.1"));
  const Box node = driver.BoxOf("canvas/Main/1.1");
  const Box beside = {{node.min.x - 24, node.min.y}, {node.min.x - 2, node.max.y}};
  EXPECT_EQ(driver.CountColor(beside, colors.failure), 0);
  driver.Press(kKeyF1 + 8);
  const int full = driver.CountColor(beside, colors.failure);
  EXPECT_GT(full, 30);
  driver.Press(kKeyF1 + 8, kShift);
  EXPECT_LT(driver.CountColor(beside, colors.failure), full) << "hollow when it is off";
  robot->StopBefore(1);
  driver.Frames();
  EXPECT_GT(driver.CountColor(beside, colors.running), 20);
}

}  // namespace
}  // namespace coppice::editor
