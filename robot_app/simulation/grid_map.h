// The occupancy grid of a floor, as a SLAM run through it would have delivered.
#ifndef COPPICE_ROBOT_APP_SIMULATION_GRID_MAP_H_
#define COPPICE_ROBOT_APP_SIMULATION_GRID_MAP_H_

#include <cstdint>
#include <vector>

#include "robot_app/simulation/floor.h"

namespace coppice::robot::simulation {

/// Row by row from the lower left corner, as nav_msgs/OccupancyGrid.
struct GridMap {
  static constexpr std::int8_t kUnknown = -1;
  static constexpr std::int8_t kFree = 0;
  static constexpr std::int8_t kOccupied = 100;

  double resolution = 0.05;  ///< m per cell
  int width = 0;
  int height = 0;
  Vec2 origin;  ///< the lower left corner of cell (0, 0) in the map frame
  std::vector<std::int8_t> cells;

  /// The value of the cell that holds a point; unknown outside of the grid.
  std::int8_t At(Vec2 point) const;
  Vec2 Center(int column, int row) const {
    return {origin.x + (column + 0.5) * resolution, origin.y + (row + 0.5) * resolution};
  }
};

/// The edges of what is too low for a laser, such as kerbs, are unknown: nobody drives there, and
/// no beam is expected to end there. Walls, furniture, the station's landmark and door leaves as
/// they stand at the start are occupied; what can be walked to from the charging station (through
/// any door) is free; the rest is unknown.
GridMap MakeGridMap(const Floor& floor, double resolution = 0.05);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_GRID_MAP_H_
