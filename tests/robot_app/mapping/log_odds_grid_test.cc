#include "robot_app/mapping/log_odds_grid.h"

#include <gtest/gtest.h>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::mapping {
namespace {

std::int8_t At(const OccupancyGrid& map, double x, double y) {
  const Cell cell = map.frame.CellAt(x, y);
  return map.frame.Contains(cell) ? map.cells[map.frame.Index(cell)] : std::int8_t{-1};
}

// One beam straight on from the origin.
LaserScan Beam(double range) {
  LaserScan scan;
  scan.mount = {};
  scan.angle_min = 0;
  scan.ranges = {static_cast<float>(range)};
  return scan;
}

TEST(LogOddsGrid, IsFreeOnTheWayAndOccupiedAtTheEnd) {
  LogOddsGrid grid(0.05);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(grid.Add(Beam(3), {1, 1, M_PI / 2}, 10));
  const OccupancyGrid map = grid.ToMap();
  EXPECT_GE(At(map, 1, 4), OccupancyGrid::kOccupied);
  EXPECT_LT(At(map, 1, 2), 30);
  EXPECT_EQ(At(map, 1, 4.2), -1);
  EXPECT_EQ(At(map, 2, 2), -1);
  EXPECT_NEAR(map.frame.width, 21, 2);  // no larger than what is known, with a border
}

TEST(LogOddsGrid, BelievesNothingBeyondTheRange) {
  LogOddsGrid grid(0.05);
  for (int i = 0; i < 3; ++i) grid.Add(Beam(6), {}, 4);
  for (int i = 0; i < 3; ++i) grid.Add(Beam(INFINITY), {0, 1, 0}, 4);
  const OccupancyGrid map = grid.ToMap();
  EXPECT_LT(At(map, 3.9, 0), 30);
  EXPECT_GE(At(map, 3.9, 0), 0);
  EXPECT_EQ(At(map, 6, 0), -1);
  EXPECT_LT(At(map, 3.9, 1), 30);
  EXPECT_GE(At(map, 3.9, 1), 0);
}

TEST(LogOddsGrid, WhatIsNoEchoSaysNothing) {
  LogOddsGrid grid(0.05);
  grid.Add(Beam(NAN), {}, 4);
  grid.Add(Beam(0.001), {}, 4);
  EXPECT_FALSE(grid.Add(Beam(1), {NAN, 0, 0}, 4));
  for (const std::int8_t cell : grid.ToMap().cells) EXPECT_EQ(cell, -1);
}

TEST(LogOddsGrid, ForgetsSomebodyWhoHasGoneOn) {
  LogOddsGrid grid(0.05);
  for (int i = 0; i < 3; ++i) grid.Add(Beam(2), {}, 10);
  EXPECT_GE(At(grid.ToMap(), 2, 0), OccupancyGrid::kOccupied);
  for (int i = 0; i < 10; ++i) grid.Add(Beam(5), {}, 10);
  EXPECT_LT(At(grid.ToMap(), 2, 0), 30);
  EXPECT_GE(At(grid.ToMap(), 5, 0), OccupancyGrid::kOccupied);
}

TEST(LogOddsGrid, AnEndCountsBeforeTheWayOfAnotherBeam) {
  LogOddsGrid grid(0.05);
  LaserScan scan = Beam(2);
  scan.angle_increment = 1e-4;
  scan.ranges = {2, 6, 6, 6};  // past an edge
  for (int i = 0; i < 3; ++i) grid.Add(scan, {}, 10);
  EXPECT_GE(At(grid.ToMap(), 2, 0), OccupancyGrid::kOccupied);
}

TEST(LogOddsGrid, KeepsWhatItKnowsWhenItGrows) {
  LogOddsGrid grid(0.05);
  for (int i = 0; i < 3; ++i) grid.Add(Beam(2), {}, 4);
  for (int i = 0; i < 3; ++i) grid.Add(Beam(2), {-30, -20, M_PI}, 4);
  for (int i = 0; i < 3; ++i) grid.Add(Beam(2), {15, 40, 0}, 4);
  const OccupancyGrid map = grid.ToMap();
  EXPECT_GE(At(map, 2, 0), OccupancyGrid::kOccupied);
  EXPECT_GE(At(map, -32, -20), OccupancyGrid::kOccupied);
  EXPECT_GE(At(map, 17, 40), OccupancyGrid::kOccupied);
  EXPECT_LT(At(map, 1, 0), 30);
}

TEST(LogOddsGrid, DoesNotGrowWithoutEnd) {
  LogOddsGrid grid(0.05);
  ASSERT_TRUE(grid.Add(Beam(2), {}, 10));
  EXPECT_FALSE(grid.Add(Beam(2), {1e4, 1e4, 0}, 10));
  EXPECT_FALSE(grid.Add(Beam(2), {1e300, 0, 0}, 10));
  EXPECT_FALSE(grid.Add(Beam(2), {220, 200, 0}, 10)) << "19 million cells";
  EXPECT_GE(At(grid.ToMap(), 2, 0), 0);
}

}  // namespace
}  // namespace coppice::robot::mapping
