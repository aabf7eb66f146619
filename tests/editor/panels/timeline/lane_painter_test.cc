#include "editor/panels/timeline/lane_painter.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(LanePainter, AFailureOutweighsTheRest) {
  EXPECT_EQ(WorstOf(SetOf(Status::kSuccess) | SetOf(Status::kFailure)), Status::kFailure);
  EXPECT_EQ(WorstOf(SetOf(Status::kSuccess) | SetOf(Status::kRunning)), Status::kRunning);
  EXPECT_EQ(WorstOf(SetOf(Status::kIdle)), Status::kIdle);
}

TEST(LanePainter, MarksOfAnAxisAreRoundAndNotTooMany) {
  EXPECT_EQ(MarkDistance(std::chrono::seconds(10), 10), std::chrono::seconds(1));
  EXPECT_EQ(MarkDistance(std::chrono::seconds(100), 10), std::chrono::seconds(10));
  EXPECT_EQ(MarkDistance(std::chrono::minutes(50), 10), std::chrono::minutes(5));
  EXPECT_GT(MarkDistance(std::chrono::hours(24 * 365), 10), std::chrono::hours(24 * 36));
}

// In grey they look the same only if their form is the same.
TEST(LanePainter, TheFormOfANarrowBarSaysItsStatus) {
  const auto rows = [](Status status) {
    Driver driver;
    auto source = std::make_unique<ExecutedSource>("a.coppice", kDoorTrees, false);
    source->tree.results["drive"] = Status::kRunning;
    source->Ticks(3);
    source->tree.results["drive"] = status;
    source->Ticks(1);
    source->tree.results["drive"] = Status::kRunning;
    source->Ticks(40);
    driver.editor.AddRun(std::move(source));
    driver.Frames(8);
    const Box lane = driver.BoxOf("timeline/pass/Drive");
    const Palette& palette = GetPalette(PaletteName::kDark);
    const Color color = Mix(palette.panel, palette.Of(status), 0.5F);  // it is past
    std::string form;
    for (float y = lane.min.y; y < lane.max.y; ++y) {
      const Box row = {{lane.min.x, y}, {lane.max.x, y + 1}};
      form += driver.CountColor(row, color, 4) > 0 ? '#' : '.';
    }
    return form;
  };
  const std::string success = rows(Status::kSuccess);
  const std::string failure = rows(Status::kFailure);
  EXPECT_NE(success.find("##"), std::string::npos) << success;
  EXPECT_NE(failure.find("##"), std::string::npos) << failure;
  EXPECT_NE(success, failure);
}

TEST(LanePainter, OnlyWhatHoldsAtThePlayheadHasItsFullColour) {
  Driver driver;
  auto source = std::make_unique<ExecutedSource>("a.coppice", kDoorTrees, false);
  source->tree.results["drive"] = Status::kRunning;
  source->Ticks(20);
  source->tree.results["drive"] = Status::kFailure;
  source->Ticks(20);
  driver.editor.AddRun(std::move(source));
  driver.Frames(8);
  const Box lane = driver.BoxOf("timeline/pass/Drive");
  const auto count = [&](Status status) {
    return driver.CountColor(lane, GetPalette(PaletteName::kDark).Of(status), 4);
  };
  EXPECT_EQ(count(Status::kRunning), 0);
  EXPECT_GT(count(Status::kFailure), 100);
  driver.editor.state().workspace.run()->playhead().GoToTick(5);
  driver.Frames(4);
  EXPECT_GT(count(Status::kRunning), 100);
  EXPECT_EQ(count(Status::kFailure), 0);
}

}  // namespace
}  // namespace coppice::editor
