// Scans of the planar laser of a few round things, for tests: the laser stands at the origin and
// looks along x.
#ifndef COPPICE_TESTS_ROBOT_APP_PERCEPTION_LEGS_MADE_SCAN_H_
#define COPPICE_TESTS_ROBOT_APP_PERCEPTION_LEGS_MADE_SCAN_H_

#include <vector>

#include "robot_app/simulation/lidar.h"
#include "robot_app/training/labelled_sweep.h"

namespace coppice::robot::perception {

/// What it sees of these discs and of a wall far ahead; half a degree between two beams.
inline LaserScan ScanOf(const std::vector<simulation::Disc>& discs, double noise = 0) {
  simulation::LidarOptions options;
  options.mounting = {0, 0, 0};
  options.noise = noise;
  simulation::Lidar laser(options, 1);
  laser.Measure(0, {0, 0, 0},
                simulation::RayCaster(std::vector<simulation::Segment>{{{6, -5}, {6, 5}}}), discs);
  return training::ToLaserScan(laser);
}

/// Somebody who stands there, with legs side by side across the view.
inline std::vector<simulation::Disc> LegsAt(double x, double y) {
  return {{{x, y + 0.1}, 0.075}, {{x, y - 0.1}, 0.075}};
}

}  // namespace coppice::robot::perception

#endif  // COPPICE_TESTS_ROBOT_APP_PERCEPTION_LEGS_MADE_SCAN_H_
