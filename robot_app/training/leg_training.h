// Learns to tell legs in scans of the planar laser from all else, from simulated scans of random
// halls, and says how well people are found by them in scans of any site.
#ifndef COPPICE_ROBOT_APP_TRAINING_LEG_TRAINING_H_
#define COPPICE_ROBOT_APP_TRAINING_LEG_TRAINING_H_

#include <functional>

#include "robot_app/perception/legs/leg_finder.h"
#include "robot_app/training/labelled_sweep.h"
#include "robot_app/training/people_figures.h"

namespace coppice::robot::training {

struct LegTrainingOptions {
  std::uint64_t seed = 1;
  int scans = 700;  ///< of a round, each in a hall of its own
  int rounds = 3;   ///< each after the first learns also from what the one before took for legs
  int most_four_legged = 8;  ///< chairs and tables around the robot
  perception::LegClassifier::Training trees{60, 4};
};

/// `say` is told how far it is, 0..1. The same options give the same classifier.
Expected<perception::LegClassifier> TrainLegs(const LegTrainingOptions& options,
                                              const std::function<void(double)>& say);

/// Looks for people in `scans` scans of a site with up to `most_four_legged` chairs and tables
/// around the robot.
PeopleFigures MeasureLegs(perception::LegFinder& finder, const Site& site, int scans,
                          int most_four_legged, std::uint64_t seed);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_LEG_TRAINING_H_
