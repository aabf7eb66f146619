// Scans of the simulated planar laser with the truth about the people in them.
#ifndef COPPICE_ROBOT_APP_TRAINING_LABELLED_SWEEP_H_
#define COPPICE_ROBOT_APP_TRAINING_LABELLED_SWEEP_H_

#include <random>
#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/simulation/lidar.h"
#include "robot_app/training/labelled_scan.h"

namespace coppice::robot::training {

struct LabelledSweep {
  static constexpr int kNobody = -1;

  LaserScan scan;
  /// In the scanner's axes; `visible` is the share of the beams that meet the person's legs of
  /// those that would with nothing else around.
  std::vector<PersonTruth> people;
  std::vector<int> owner;  ///< of each beam: whom it met, or kNobody
};

struct SweepOptions {
  simulation::LidarOptions laser;
  int most_four_legged = 0;  ///< at most so many chairs and tables on four thin legs
};

/// Puts the robot and up to ten people at random on the free floor of a site and measures one scan.
/// The same state of `random` gives the same scan.
LabelledSweep MakeLabelledSweep(const Site& site, const SweepOptions& options,
                                std::mt19937_64& random);

/// What the simulated laser measured, as the robot's programs take it.
LaserScan ToLaserScan(const simulation::Lidar& laser);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_LABELLED_SWEEP_H_
