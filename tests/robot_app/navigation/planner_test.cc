#include "robot_app/navigation/planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::navigation {
namespace {

using testing::HasSubstr;

// The same rules as the planner's, solved by relaxing all steps until nothing changes.
double BruteForceCost(const Costmap& costmap, Cell start, Cell goal) {
  const GridFrame& frame = costmap.frame();
  std::vector<double> best(frame.size(), HUGE_VAL);
  best[frame.Index(start)] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 0; i < frame.size(); ++i) {
      if (best[i] == HUGE_VAL) continue;
      const Cell cell = frame.CellOf(i);
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell next{cell.x + dx, cell.y + dy};
          if (costmap.Lethal(next) || costmap.Lethal(Cell{next.x, cell.y}) ||
              costmap.Lethal(Cell{cell.x, next.y})) {
            continue;
          }
          const int to = frame.Index(next);
          const double cost = best[i] + frame.resolution * std::hypot(dx, dy) * 0.5 *
                                            (costmap.cost(i) + costmap.cost(to));
          if (cost < best[to] - 1e-9) {
            best[to] = cost;
            changed = true;
          }
        }
      }
    }
  }
  return best[frame.Index(goal)];
}

OccupancyGrid RandomRoom(std::mt19937& random, double size, int boxes) {
  OccupancyGrid grid = EmptyRoom(size, size, 0.1);
  std::uniform_real_distribution<double> place(0, size);
  for (int i = 0; i < boxes; ++i) {
    const Point2D low{place(random), place(random)};
    Fill(grid, low, {low.x + 0.35, low.y + 0.35}, random() % 4 == 0 ? -1 : 100);
  }
  return grid;
}

TEST(Planner, FindsTheCheapestWayOnRandomGrids) {
  std::mt19937 random(11);
  int found = 0;
  int none = 0;
  for (int round = 0; round < 120; ++round) {
    const OccupancyGrid grid = RandomRoom(random, 4, 10);
    Costmap costmap;
    costmap.Update(grid);
    const Cell start{static_cast<int>(random() % 40), static_cast<int>(random() % 40)};
    const Cell goal{static_cast<int>(random() % 40), static_cast<int>(random() % 40)};
    if (costmap.Lethal(start) || costmap.Lethal(goal)) continue;
    const double expected = BruteForceCost(costmap, start, goal);
    const Plan plan = FindPath(costmap, grid.frame.Center(start), grid.frame.Center(goal));
    if (expected == HUGE_VAL) {
      EXPECT_EQ(plan.status, PlanStatus::kNoPath);
      ++none;
    } else {
      ASSERT_EQ(plan.status, PlanStatus::kOk) << plan.message;
      EXPECT_NEAR(plan.cost, expected, 1e-3 + 1e-4 * expected);
      ++found;
    }
  }
  EXPECT_GT(found, 10);
  EXPECT_GT(none, 0);
}

TEST(Planner, NeitherPathNorSmoothedPathTouchesALethalCell) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> place(0, 8);
  int found = 0;
  for (int round = 0; round < 150; ++round) {
    const OccupancyGrid grid = RandomRoom(random, 8, 14);
    Costmap costmap;
    costmap.Update(grid);
    const Point2D start{place(random), place(random)};
    const Point2D goal{place(random), place(random)};
    if (costmap.Lethal(grid.frame.CellAt(start.x, start.y))) continue;
    const Plan plan = FindPath(costmap, start, goal);
    if (plan.status != PlanStatus::kOk) continue;
    ++found;
    EXPECT_TRUE(PathIsFree(costmap, plan.points)) << "round " << round;
    const std::vector<Point2D> smooth = SmoothPath(costmap, plan.points);
    EXPECT_TRUE(PathIsFree(costmap, smooth)) << "round " << round;
    EXPECT_LE(PathLength(smooth), PathLength(plan.points) + 0.05);
    EXPECT_DOUBLE_EQ(smooth.front().x, start.x);
    EXPECT_DOUBLE_EQ(smooth.back().y, goal.y);
    for (std::size_t i = 1; i < smooth.size(); ++i) {
      EXPECT_LT(Distance(smooth[i - 1], smooth[i]), 0.16);
    }
  }
  EXPECT_GT(found, 20);
}

// Each longer line costs more to look at: without an end of it this took half a minute.
TEST(Planner, SmoothsAWayOfHundredThousandCellsSoon) {
  OccupancyGrid corridor;
  corridor.frame = {0.05, 0, 0, 100'000, 20};
  corridor.cells.assign(static_cast<std::size_t>(corridor.frame.size()), 0);
  CostSettings settings;
  settings.lethal_radius = 0.1;
  settings.inflation_radius = 0.2;
  Costmap costmap(settings);
  costmap.Update(corridor);
  std::vector<Point2D> path;
  for (int x = 0; x < corridor.frame.width; ++x) path.push_back(corridor.frame.Center({x, 10}));
  const auto begun = std::chrono::steady_clock::now();
  const std::vector<Point2D> smooth = SmoothPath(costmap, path);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(10));
  EXPECT_TRUE(PathIsFree(costmap, smooth, 0));
  EXPECT_NEAR(PathLength(smooth), PathLength(path), 0.01);
}

TEST(Planner, SaysHowFarTheNearestFreePlaceIsWhenTheGoalIsBlocked) {
  OccupancyGrid room = EmptyRoom(6, 6);
  Fill(room, {3, 3}, {3.5, 3.5});
  Costmap costmap;
  costmap.Update(room);
  const Plan plan = FindPath(costmap, {1, 1}, {3.25, 3.05});
  EXPECT_EQ(plan.status, PlanStatus::kGoalBlocked);
  EXPECT_TRUE(plan.points.empty());
  EXPECT_THAT(plan.message, HasSubstr("the goal (3.25, 3.05) is blocked"));
  EXPECT_THAT(plan.message, HasSubstr("0.4"));
  EXPECT_EQ(FindPath(costmap, {1, 1}, {-4, 2}).status, PlanStatus::kGoalBlocked) << "outside";
}

TEST(Planner, LeavesLethalCellsThatItStartsIn) {
  const OccupancyGrid room = EmptyRoom(6, 6);
  Costmap costmap;
  costmap.Update(room);
  const Plan plan = FindPath(costmap, {0.3, 3}, {3, 3});
  ASSERT_EQ(plan.status, PlanStatus::kOk) << plan.message;
  EXPECT_DOUBLE_EQ(plan.points.front().x, 0.3);
  EXPECT_FALSE(PathIsFree(costmap, plan.points));
  EXPECT_TRUE(PathIsFree(costmap, SmoothPath(costmap, plan.points), 0.3));
}

TEST(Planner, RefusesAStartDeepInAnObstacle) {
  OccupancyGrid room = EmptyRoom(6, 6);
  Fill(room, {1, 1}, {3, 3});
  Costmap costmap;
  costmap.Update(room);
  const Plan plan = FindPath(costmap, {2, 2}, {5, 5});
  EXPECT_EQ(plan.status, PlanStatus::kStartBlocked);
  EXPECT_THAT(plan.message, HasSubstr("(2.00, 2.00) stands in an obstacle"));
}

TEST(Planner, FindsNoWayThroughUnknownSpace) {
  OccupancyGrid room = EmptyRoom(6, 6);
  Fill(room, {2.8, 0}, {3.2, 6}, -1);
  Costmap costmap;
  costmap.Update(room);
  const Plan plan = FindPath(costmap, {1, 1}, {5, 5});
  EXPECT_EQ(plan.status, PlanStatus::kNoPath);
  EXPECT_THAT(plan.message, HasSubstr("no way to (5.00, 5.00) is free"));
}

TEST(Planner, KeepsToTheMiddleOfADoorway) {
  OccupancyGrid room = EmptyRoom(6, 6);
  Fill(room, {2.9, 0}, {3.1, 2.4});
  Fill(room, {2.9, 3.6}, {3.1, 6});
  Costmap costmap;
  costmap.Update(room);
  const Plan plan = FindPath(costmap, {1, 1}, {5, 5});
  ASSERT_EQ(plan.status, PlanStatus::kOk);
  for (const Point2D& point : SmoothPath(costmap, plan.points)) {
    if (std::abs(point.x - 3) < 0.1) {
      EXPECT_NEAR(point.y, 3, 0.12);
    }
  }
}

}  // namespace
}  // namespace coppice::robot::navigation
