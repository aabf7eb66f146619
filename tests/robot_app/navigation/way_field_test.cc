#include "robot_app/navigation/way_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/navigation/planner.h"
#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::navigation {
namespace {

// 10 x 6 m, with a wall at x = 5 that leaves a gap at its upper end.
OccupancyGrid TwoRooms() {
  OccupancyGrid map = EmptyRoom(10, 6);
  Fill(map, {4.9, 0}, {5.1, 4.5});
  return map;
}

Costmap CostsOf(const OccupancyGrid& map) {
  Costmap costs;
  costs.Update(map);
  return costs;
}

TEST(WayField, TellsTheLengthOfAStraightWay) {
  const WayField ways(CostsOf(EmptyRoom(10, 6)), {2, 3});
  ASSERT_TRUE(ways.Length({8, 3}));
  EXPECT_NEAR(*ways.Length({8, 3}), 6, 0.1);
  EXPECT_NEAR(*ways.Length({2, 3}), 0, 0.1);
}

TEST(WayField, GoesAroundWalls) {
  const Costmap costs = CostsOf(TwoRooms());
  const WayField ways(costs, {4, 1});
  const double length = *ways.Length({6, 1});
  const Plan plan = FindPath(costs, {6, 1}, {4, 1});
  EXPECT_GT(length, 8);  // the straight line is 2 m
  EXPECT_NEAR(length, PathLength(plan.points), 0.1);
}

TEST(WayField, AgreesWithThePlannerEverywhere) {
  const Costmap costs = CostsOf(TwoRooms());
  const WayField ways(costs, {1.2, 1});
  for (double x = 0.7; x < 9.5; x += 1.1) {
    if (std::abs(x - 5) < 0.5) continue;  // the wall
    for (double y = 0.7; y < 5.5; y += 1.1) {
      const Plan plan = FindPath(costs, {x, y}, {1.2, 1});
      ASSERT_EQ(plan.status, PlanStatus::kOk) << x << " " << y;
      EXPECT_NEAR(*ways.Length({x, y}), PathLength(plan.points), 0.35) << x << " " << y;
    }
  }
}

TEST(WayField, KnowsAStationAndARobotThatAreNearAWall) {
  const WayField ways(CostsOf(EmptyRoom(10, 6)), {0.2, 3});
  EXPECT_NEAR(*ways.Length({9.8, 3}), 9.6, 0.3);
}

TEST(WayField, SaysNothingWhereNoWayLeads) {
  OccupancyGrid map = TwoRooms();
  Fill(map, {4.9, 4}, {5.1, 6});
  const WayField ways(CostsOf(map), {2, 3});
  EXPECT_TRUE(ways.Length({3, 3}));
  EXPECT_FALSE(ways.Length({8, 3}));
  EXPECT_FALSE(ways.Length({-5, 3}));
  EXPECT_FALSE(ways.Length({NAN, 3}));
  EXPECT_FALSE(WayField(CostsOf(map), {20, 20}).Length({3, 3}));
}

}  // namespace
}  // namespace coppice::robot::navigation
