// Turns of the simulated 3-D lidar with the truth about the people in them.
#ifndef COPPICE_ROBOT_APP_TRAINING_LABELLED_SCAN_H_
#define COPPICE_ROBOT_APP_TRAINING_LABELLED_SCAN_H_

#include <cstdint>
#include <random>
#include <vector>

#include "robot_app/perception/clouds/range_image.h"
#include "robot_app/simulation/lidar_3d.h"
#include "robot_app/training/random_hall.h"

namespace coppice::robot::training {

/// A person in a scan.
struct PersonTruth {
  simulation::Vec2 position;  ///< from the sensor's foot, in its axes [m]
  /// Of the points that the sensor would have on the person with nothing else around, the share
  /// that it has; 0: hidden.
  double visible = 0;
  bool in_group = false;  ///< two others stand within 0.8 m
};

struct LabelledScan {
  std::vector<perception::LidarPoint> points;
  std::vector<PersonTruth> people;
};

/// Puts the sensor and up to ten people at random on the free floor of a site and measures one
/// turn. People stand or walk, alone, in groups of three, and before each other. The same state of
/// `random` gives the same scan.
LabelledScan MakeLabelledScan(const Site& site, const simulation::Lidar3dOptions& lidar,
                              std::mt19937_64& random);

/// What the simulated lidar measured, as perception takes it.
std::vector<perception::LidarPoint> ToPoints(const simulation::Cloud& cloud);

/// Of the points that the sensor would have on a person with nothing else around, the share that
/// `all` leaves to see. `sensor` is the place of the sensor's foot.
double VisibleShare(const simulation::Figure& figure, const simulation::Scene& all,
                    const simulation::Pose2& sensor, const simulation::Lidar3dOptions& lidar);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_LABELLED_SCAN_H_
