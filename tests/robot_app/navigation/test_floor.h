// Small floors for tests: grids drawn from boxes, and an ideal robot that sees and drives on them.
#ifndef COPPICE_TESTS_ROBOT_APP_NAVIGATION_TEST_FLOOR_H_
#define COPPICE_TESTS_ROBOT_APP_NAVIGATION_TEST_FLOOR_H_

#include <algorithm>
#include <cmath>

#include "robot_app/common/laser_scan.h"
#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::navigation {

/// A free room of `width` x `height` metres with walls of one cell, its corner at (0, 0).
inline OccupancyGrid EmptyRoom(double width, double height, double resolution = 0.05) {
  OccupancyGrid grid;
  grid.frame.resolution = resolution;
  grid.frame.width = static_cast<int>(std::lround(width / resolution));
  grid.frame.height = static_cast<int>(std::lround(height / resolution));
  grid.cells.assign(grid.frame.size(), 0);
  for (int i = 0; i < grid.frame.size(); ++i) {
    const Cell cell = grid.frame.CellOf(i);
    if (cell.x == 0 || cell.y == 0 || cell.x + 1 == grid.frame.width ||
        cell.y + 1 == grid.frame.height) {
      grid.cells[i] = 100;
    }
  }
  return grid;
}

/// Sets the cells of a box [m].
inline void Fill(OccupancyGrid& grid, Point2D low, Point2D high, std::int8_t value = 100) {
  for (int i = 0; i < grid.frame.size(); ++i) {
    const Point2D center = grid.frame.Center(grid.frame.CellOf(i));
    if (center.x > low.x && center.x < high.x && center.y > low.y && center.y < high.y) {
      grid.cells[i] = value;
    }
  }
}

/// What a laser without noise sees of the occupied cells from `pose`.
inline LaserScan ScanOf(const OccupancyGrid& grid, const Pose2D& pose, double stamp) {
  LaserScan scan;
  scan.stamp = stamp;
  scan.ranges.assign(541, INFINITY);
  const Pose2D laser = Compose(pose, scan.mount);
  const Point2D from{laser.x, laser.y};
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Point2D to = Compose(laser, Point2D{10 * std::cos(angle), 10 * std::sin(angle)});
    TraceLine(grid.frame, from, to, [&](Cell cell) {
      if (!grid.frame.Contains(cell)) return false;
      if (grid.cells[grid.frame.Index(cell)] < OccupancyGrid::kOccupied) return true;
      const Point2D center = grid.frame.Center(cell);
      scan.ranges[i] = static_cast<float>(Distance(from, center));
      return false;
    });
  }
  return scan;
}

/// Distance of the robot's centre to the middle of the nearest occupied cell [m].
inline double Clearance(const OccupancyGrid& grid, const Pose2D& pose) {
  double nearest = HUGE_VAL;
  const Cell here = grid.frame.CellAt(pose.x, pose.y);
  const int reach = static_cast<int>(1.0 / grid.frame.resolution);
  for (int y = here.y - reach; y <= here.y + reach; ++y) {
    for (int x = here.x - reach; x <= here.x + reach; ++x) {
      const Cell cell{x, y};
      if (!grid.frame.Contains(cell)) continue;
      if (grid.cells[grid.frame.Index(cell)] < OccupancyGrid::kOccupied) continue;
      nearest = std::min(nearest, Distance(grid.frame.Center(cell), Point2D{pose.x, pose.y}));
    }
  }
  return nearest;
}

}  // namespace coppice::robot::navigation

#endif  // COPPICE_TESTS_ROBOT_APP_NAVIGATION_TEST_FLOOR_H_
