// How right a map is, measured with the floor that was mapped.
#ifndef COPPICE_TESTS_ROBOT_APP_MAPPING_MAP_QUALITY_H_
#define COPPICE_TESTS_ROBOT_APP_MAPPING_MAP_QUALITY_H_

#include <vector>

#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::mapping {

/// Of the cells of `map` that are occupied and lie within [low, high], the share that has an
/// occupied cell of `other` within `near` [m]. Of the map against the floor: how much of it is
/// true; of the floor against the map: how much of it is there.
inline double ShareNear(const OccupancyGrid& map, const OccupancyGrid& other, double near,
                        Point2D low = {-1e9, -1e9}, Point2D high = {1e9, 1e9}) {
  std::vector<std::uint8_t> occupied(other.cells.size());
  for (std::size_t i = 0; i < other.cells.size(); ++i) {
    occupied[i] = other.cells[i] >= OccupancyGrid::kOccupied ? 1 : 0;
  }
  const std::vector<float> distance = DistanceTransform(other.frame, occupied, 1);
  int all = 0;
  int right = 0;
  for (int i = 0; i < map.frame.size(); ++i) {
    if (map.cells[i] < OccupancyGrid::kOccupied) continue;
    const Point2D center = map.frame.Center(map.frame.CellOf(i));
    if (center.x < low.x || center.y < low.y || center.x > high.x || center.y > high.y) continue;
    ++all;
    const Cell cell = other.frame.CellAt(center.x, center.y);
    if (other.frame.Contains(cell) && distance[other.frame.Index(cell)] <= near) ++right;
  }
  return all == 0 ? 0 : static_cast<double>(right) / all;
}

}  // namespace coppice::robot::mapping

#endif  // COPPICE_TESTS_ROBOT_APP_MAPPING_MAP_QUALITY_H_
