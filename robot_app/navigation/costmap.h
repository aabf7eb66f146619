// What it costs to have the robot's centre in a cell.
//
// Lethal where the robot, a disc, would touch something; above that the cost falls with the
// distance to the nearest obstacle, so that paths keep to the middle where there is room.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_COSTMAP_H_
#define COPPICE_ROBOT_APP_NAVIGATION_COSTMAP_H_

#include <cstdint>
#include <limits>
#include <vector>

#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::navigation {

struct CostSettings {
  double lethal_radius = 0.38;    ///< robot's radius and a margin [m]
  double inflation_radius = 1.0;  ///< obstacles farther away cost nothing [m]
  double near_cost = 4.0;         ///< extra cost per metre at the lethal radius
  double cost_falls_over = 0.25;  ///< distance over which the extra cost falls to 1/e [m]
};

class Costmap {
 public:
  static constexpr float kLethal = std::numeric_limits<float>::infinity();

  explicit Costmap(CostSettings settings = {}) : settings_(settings) {}

  /// Computes all costs. `obstacles`: cells that are blocked though they are free on the map.
  void Update(const OccupancyGrid& map, const std::vector<int>& obstacles = {});

  const GridFrame& frame() const { return frame_; }
  /// Cost of driving one metre in that cell: >= 1, or kLethal.
  float cost(int index) const { return cost_[index]; }
  bool Lethal(int index) const { return cost_[index] == kLethal; }
  /// True for cells outside the grid as well.
  bool Lethal(Cell cell) const { return !frame_.Contains(cell) || Lethal(frame_.Index(cell)); }

 private:
  CostSettings settings_;
  GridFrame frame_;
  std::vector<float> cost_;
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_COSTMAP_H_
