#include "editor/canvas/paint/edge_painter.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

// Between a parent and its child there is nothing but the edge.
Box Between(const Driver& driver, const std::string& parent, const std::string& child) {
  const Box a = driver.BoxOf(parent);
  const Box b = driver.BoxOf(child);
  return {{std::min(a.min.x, b.min.x), a.max.y + 8}, {std::max(a.max.x, b.max.x), b.min.y - 8}};
}

TEST(EdgePainter, PaintsTheStatusOfTheChildOnTheEdge) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  const Palette& colors = GetPalette(PaletteName::kDark);
  const Box gap = Between(driver, "canvas/Main/1.2", "canvas/Main/1.2.1");
  EXPECT_EQ(driver.CountColor(gap, colors.running), 0);
  robot->Set(4, Status::kRunning);
  driver.Frames(20);
  // The dots are of a lighter colour and cover a part of the line.
  const int running = driver.CountColor(gap, colors.running) +
                      driver.CountColor(gap, Mix(colors.running, 0xFFFFFFFF, 0.45F), 10);
  EXPECT_GT(driver.CountColor(gap, colors.running), 10);
  robot->Set(4, Status::kSuccess);
  driver.Frames(20);
  EXPECT_EQ(driver.CountColor(gap, colors.running), 0);
  const int success = driver.CountColor(gap, colors.success);
  EXPECT_GT(success, 5);
  EXPECT_LT(success, running) << "only the running path is thick";
}

}  // namespace
}  // namespace coppice::editor
