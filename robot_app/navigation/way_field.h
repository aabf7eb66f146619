// How far it is from anywhere on the map to one place, around the walls: for the battery, which
// must last for the way to the charging station.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_WAY_FIELD_H_
#define COPPICE_ROBOT_APP_NAVIGATION_WAY_FIELD_H_

#include <optional>
#include <vector>

#include "robot_app/navigation/costmap.h"

namespace coppice::robot::navigation {

class WayField {
 public:
  /// The cheapest ways of all cells to the place `to` [m, map frame], as the planner would choose
  /// them (E. W. Dijkstra: A Note on Two Problems in Connexion with Graphs, 1959). Takes as long as
  /// the longest of all plans: 0.1 s for a floor of 55 x 13 m.
  WayField(const Costmap& costmap, Point2D to);

  /// Length of the way [m], along the grid: up to 8 % longer than a smoothed path. Nothing if no
  /// way leads there on the map. Places that are too near to a wall begin at the next free cell
  /// within a metre. A lookup.
  std::optional<double> Length(Point2D from) const;

 private:
  std::optional<double> NearestLength(Point2D from) const;

  GridFrame frame_;
  std::vector<float> length_;  // of each cell; infinite: no way
  double last_step_ = 0;       // from the nearest free cell to the place itself
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_WAY_FIELD_H_
