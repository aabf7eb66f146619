// What the laser has seen lately that is not on the map: people, boxes, closed doors.
//
// A reading marks the cell at its end and clears the cells on its way. What is marked and never
// looked at again is forgotten after a while, so that a blocked corridor opens again by itself.
// Marking and clearing as in D. V. Lu, D. Hershberger, W. D. Smart: Layered Costmaps for
// Context-Sensitive Navigation, IROS 2014. Not thread-safe.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_OBSTACLE_LAYER_H_
#define COPPICE_ROBOT_APP_NAVIGATION_OBSTACLE_LAYER_H_

#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/navigation/marked_cells.h"

namespace coppice::robot::navigation {

struct ObstacleSettings {
  double mark_range = 8.0;   ///< readings up to here mark [m]
  double clear_range = 9.0;  ///< free space is believed up to here [m]
  double forget_after = 20;  ///< marks not seen again are dropped after this time [s]
};

class ObstacleLayer {
 public:
  explicit ObstacleLayer(ObstacleSettings settings = {}) : settings_(settings) {}

  /// Starts empty on a grid.
  void Reset(const GridFrame& frame) { marks_.Reset(frame); }

  /// Enters a scan taken at `pose` (base_link in the map frame).
  void Insert(const Pose2D& pose, const LaserScan& scan);

  /// Drops marks that are older than `forget_after` at `now` [s].
  void Forget(double now) { marks_.Forget(now, settings_.forget_after); }

  /// Drops all marks. Those that the laser sees now return with the next scan.
  void Clear() { marks_.Clear(); }

  bool Marked(int index) const { return marks_.Marked(index); }
  /// The marked cells, in no particular order.
  const std::vector<int>& marked() const { return marks_.list(); }

 private:
  ObstacleSettings settings_;
  MarkedCells marks_;
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_OBSTACLE_LAYER_H_
