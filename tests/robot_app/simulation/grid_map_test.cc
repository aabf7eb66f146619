#include "robot_app/simulation/grid_map.h"

#include <gtest/gtest.h>

#include <vector>

#include "robot_app/simulation/bodies.h"
#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

TEST(GridMap, TellsWallsFromFreeFloorAndTheUnknown) {
  const GridMap map = MakeGridMap(LoadInstitute());
  EXPECT_DOUBLE_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.cells.size(), static_cast<std::size_t>(map.width) * map.height);
  EXPECT_EQ(map.At({20, 0}), GridMap::kFree);
  EXPECT_EQ(map.At({46, 0}), GridMap::kFree);
  EXPECT_EQ(map.At({8, 4}), GridMap::kFree);
  EXPECT_EQ(map.At({2, 4}), GridMap::kUnknown);      // between the buildings
  EXPECT_EQ(map.At({-9, 0}), GridMap::kUnknown);     // off the map
  EXPECT_EQ(map.At({5.2, 4.6}), GridMap::kUnknown);  // inside a desk
  EXPECT_EQ(map.At({5.61, 4.6}) == GridMap::kOccupied || map.At({5.58, 4.6}) == GridMap::kOccupied,
            true);
}

TEST(GridMap, OnlyClosedDoorsAreOccupied) {
  const Floor floor = LoadInstitute();
  const GridMap map = MakeGridMap(floor);
  for (const Door& door : floor.doors) {
    const Vec2 middle = (door.hinge + door.end) * 0.5;
    bool free = true;
    for (double dy = -0.05; dy < 0.06; dy += 0.025) {
      free = free && map.At(middle + Vec2{0, dy}) == GridMap::kFree;
    }
    EXPECT_EQ(free, door.open) << door.name;
  }
}

TEST(GridMap, WallsAreTight) {
  // No free cell touches the unknown: a planner could leak out there.
  const GridMap map = MakeGridMap(LoadInstitute());
  for (int row = 1; row < map.height; ++row) {
    for (int column = 1; column < map.width; ++column) {
      const auto here = map.At(map.Center(column, row));
      const auto left = map.At(map.Center(column - 1, row));
      const auto below = map.At(map.Center(column, row - 1));
      ASSERT_FALSE(here + left == GridMap::kFree + GridMap::kUnknown) << column << " " << row;
      ASSERT_FALSE(here + below == GridMap::kFree + GridMap::kUnknown) << column << " " << row;
    }
  }
}

// Which cells the centre of the robot can reach from a start when every occupied cell keeps
// `clearance`.
std::vector<bool> Reachable(const GridMap& map, Vec2 start, double clearance) {
  const int reach = static_cast<int>(std::ceil(clearance / map.resolution));
  std::vector<bool> blocked(map.cells.size(), false);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.cells[row * map.width + column] == GridMap::kFree) continue;
      for (int r = std::max(0, row - reach); r <= std::min(map.height - 1, row + reach); ++r) {
        for (int c = std::max(0, column - reach); c <= std::min(map.width - 1, column + reach);
             ++c) {
          if (std::hypot(r - row, c - column) * map.resolution < clearance) {
            blocked[r * map.width + c] = true;
          }
        }
      }
    }
  }
  std::vector<bool> reached(map.cells.size(), false);
  std::vector<int> todo{static_cast<int>((start.y - map.origin.y) / map.resolution) * map.width +
                        static_cast<int>((start.x - map.origin.x) / map.resolution)};
  while (!todo.empty()) {
    const int i = todo.back();
    todo.pop_back();
    if (blocked[i] || reached[i]) continue;
    reached[i] = true;
    for (const int step : {-1, 1, -map.width, map.width}) todo.push_back(i + step);
  }
  return reached;
}

TEST(GridMap, TheRobotReachesEveryWaypointOfTheInstituteWithRoomToSpare) {
  const Floor floor = LoadInstitute();
  const GridMap map = MakeGridMap(floor);
  const auto reached = Reachable(map, floor.staging.position(), kRobotRadius + 0.08);
  for (const FloorWaypoint& w : floor.waypoints) {
    const int row = static_cast<int>((w.pose.y - map.origin.y) / map.resolution);
    const int column = static_cast<int>((w.pose.x - map.origin.x) / map.resolution);
    EXPECT_TRUE(reached[row * map.width + column]) << w.name;
  }
}

}  // namespace
}  // namespace coppice::robot::simulation
