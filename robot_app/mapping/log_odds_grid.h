// A grid that gathers what scans see: how often a beam ended in a cell, and how often one went
// through it. Grows as the robot gets about.
//
// S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics (2005), ch. 9.2 (occupancy grid mapping with
// log odds). In one scan a cell counts once, and a beam's end before its way (W. Hess et al.,
// Real-Time Loop Closure in 2D LIDAR SLAM, ICRA 2016).
#ifndef COPPICE_ROBOT_APP_MAPPING_LOG_ODDS_GRID_H_
#define COPPICE_ROBOT_APP_MAPPING_LOG_ODDS_GRID_H_

#include <cstdint>
#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::mapping {

class LogOddsGrid {
 public:
  explicit LogOddsGrid(double resolution) { frame_.resolution = resolution; }

  /// A scan, taken with base_link at `pose`. Beams are believed up to `range` [m]: what they met
  /// farther away is not entered, only that the way there is free. False if the map would become
  /// too large (CheckSize); then nothing has changed.
  bool Add(const LaserScan& scan, const Pose2D& pose, double range);

  /// Probabilities of 0 to 100; unknown where no beam was. As large as what is known.
  OccupancyGrid ToMap() const;

 private:
  struct Value {
    float log_odds = 0;
    std::uint32_t scan = 0;  // the last one that counted here; 0: none
  };
  GridFrame KnownPart() const;
  bool Cover(const Point2D& middle, double range);
  void Count(Cell cell, float change);

  GridFrame frame_;
  std::vector<Value> values_;
  std::uint32_t scans_ = 0;
};

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_LOG_ODDS_GRID_H_
