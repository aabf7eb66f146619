#include "editor/canvas/paint/node_painter.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"
#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(NodePainter, GivesEachShapeItsHeader) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  const Palette& colors = GetPalette(PaletteName::kDark);
  const auto has = [&](const char* path, Color color) {
    return driver.CountColor(driver.BoxOf(std::string("canvas/MainTree/") + path), color, 6);
  };
  EXPECT_GT(has("1", colors.control), 200);
  EXPECT_GT(has("1.1.1", colors.decorator), 200);
  EXPECT_GT(has("1.1.1.1", colors.condition), 200);
  EXPECT_GT(has("1.1.2", colors.action), 200);
  EXPECT_GT(has("1.2", colors.subtree), 200);
  EXPECT_GT(has("1.2.1.1", colors.unknown), 100);
}

TEST(NodePainter, CutsTheCornersOfConditionsOnly) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  const Palette& colors = GetPalette(PaletteName::kDark);
  const auto corner = [&](const char* path) {
    const Box box = driver.BoxOf(std::string("canvas/MainTree/") + path);
    return driver.CountColor({box.min, box.min + Point{4, 4}}, colors.canvas, 10);
  };
  EXPECT_GT(corner("1.1.1.1"), 6);
  EXPECT_LT(corner("1.1.1"), 4);
}

TEST(NodePainter, FlashesWhenAStatusHasJustCome) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  driver.Frames(5);
  robot->Tick();
  robot->Set(6, Status::kSuccess);
  robot->Tick();
  driver.Frames(1);
  const std::uint64_t fresh = HashOf(driver.editor.Picture());
  driver.Frames(40);
  EXPECT_NE(HashOf(driver.editor.Picture()), fresh);
}

TEST(NodePainter, NothingMovesWhileTheRobotStands) {
  Driver driver;
  ExecutedSource* robot = AddExecuted(driver, "robot:1", 10);
  driver.Frames(3);
  const std::uint64_t running = HashOf(driver.editor.Picture());
  driver.Frames(3);
  EXPECT_NE(HashOf(driver.editor.Picture()), running) << "what runs moves";
  robot->StopBefore(NodeIndex{1});
  driver.Frames(300);
  const std::uint64_t standing = HashOf(driver.editor.Picture());
  driver.Frames(5);
  EXPECT_EQ(HashOf(driver.editor.Picture()), standing);
  EXPECT_GT(driver.editor.NextFrameIn(), 1) << "and nobody has to paint";
}

TEST(NodePainter, StrikesWhatIsDisabledAndMakesItPale) {
  const TemporaryFile file("small.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence>
    <AlwaysSuccess/><AlwaysSuccess _skipIf="true"/></Sequence></BehaviorTree></root>)");
  Driver driver;
  ASSERT_TRUE(driver.editor.Open(file.path()));
  driver.Frames();
  const Color action = GetPalette(PaletteName::kDark).action;
  EXPECT_GT(driver.CountColor(driver.BoxOf("canvas/T/1.1"), action, 6), 200);
  EXPECT_LT(driver.CountColor(driver.BoxOf("canvas/T/1.2"), action, 6), 20);
}

}  // namespace
}  // namespace coppice::editor
