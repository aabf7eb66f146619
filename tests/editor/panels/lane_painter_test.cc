#include "editor/panels/lane_painter.h"

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

}  // namespace
}  // namespace coppice::editor
