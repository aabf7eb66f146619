#include "editor/timeline/lane.h"

#include <gtest/gtest.h>

#include <random>

namespace coppice::editor {
namespace {

TEST(LaneTest, AStatusHoldsUntilTheNext) {
  Lane lane;
  lane.Set(3, Status::kRunning);
  lane.Set(7, Status::kSuccess);
  EXPECT_EQ(lane.At(2), Status::kIdle);
  EXPECT_EQ(lane.At(3), Status::kRunning);
  EXPECT_EQ(lane.At(6), Status::kRunning);
  EXPECT_EQ(lane.At(100), Status::kSuccess);
  EXPECT_EQ(lane.Since(6), 3U);
  EXPECT_EQ(lane.Since(2), 0U);
}

TEST(LaneTest, TheLastWordAboutATickCountsAndTheSameStatusAgainIsNoChange) {
  Lane lane;
  lane.Set(1, Status::kSuccess);
  lane.Set(2, Status::kIdle);
  lane.Set(2, Status::kSuccess);
  lane.Set(3, Status::kSuccess);
  EXPECT_EQ(lane.changes(), 1U);
  EXPECT_EQ(lane.Since(3), 1U);
}

TEST(LaneTest, WhatEndsAndBeginsInOneTickHasANewStart) {
  Lane lane;
  lane.Set(3, Status::kRunning);
  lane.Set(7, Status::kRunning);
  lane.Restart(7);
  lane.Set(7, Status::kRunning);
  EXPECT_EQ(lane.Since(6), 3U);
  EXPECT_EQ(lane.Since(9), 7U);
}

TEST(LaneTest, WalksFromChangeToChange) {
  Lane lane;
  lane.Set(3, Status::kRunning);
  lane.Set(7, Status::kSuccess);
  EXPECT_EQ(lane.NextChange(0), 3U);
  EXPECT_EQ(lane.NextChange(3), 7U);
  EXPECT_EQ(lane.NextChange(7), 7U);
  EXPECT_EQ(lane.ChangeBefore(9), 7U);
  EXPECT_EQ(lane.ChangeBefore(7), 3U);
  EXPECT_EQ(lane.ChangeBefore(3), 3U);
  EXPECT_EQ(lane.ChangeBefore(0), 0U);
}

TEST(LaneTest, SaysWhichStatusesOccurInAnyRange) {
  std::mt19937 random(7);
  Lane lane;
  std::vector<Status> ticks;
  Status status = Status::kIdle;
  for (std::size_t tick = 0; tick < 9000; ++tick) {
    if (random() % 2) {
      status = static_cast<Status>(random() % 100 == 0 ? 2 : random() % 2);
      lane.Set(tick, status);
    }
    ticks.push_back(status);
  }
  EXPECT_GT(lane.changes(), 1000U);
  for (int i = 0; i < 3000; ++i) {
    const std::size_t first = random() % ticks.size();
    const std::size_t end = first + random() % (i % 2 ? 9000 : 40);
    StatusSet expected = 0;
    for (std::size_t t = first; t < end; ++t)
      expected |= SetOf(ticks[std::min(t, ticks.size() - 1)]);
    ASSERT_EQ(lane.Seen(first, end), expected) << first << " to " << end;
  }
  EXPECT_EQ(lane.Seen(5, 5), 0);
}

}  // namespace
}  // namespace coppice::editor
