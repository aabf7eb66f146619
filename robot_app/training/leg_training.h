// Learns to tell legs in scans of the planar laser from all else, from simulated scans of random
// halls, and says how well people are found by them in scans of any site.
#ifndef COPPICE_ROBOT_APP_TRAINING_LEG_TRAINING_H_
#define COPPICE_ROBOT_APP_TRAINING_LEG_TRAINING_H_

#include "robot_app/perception/legs/leg_finder.h"
#include "robot_app/training/labelled_sweep.h"
#include "robot_app/training/learning_rounds.h"
#include "robot_app/training/people_figures.h"

namespace coppice::robot::training {

struct LegTrainingOptions {
  LearningRounds learning{1, 700, 3, {60, 4}};
  int most_four_legged = 8;  ///< chairs and tables around the robot
};

/// The same options give the same classifier.
Expected<perception::LegClassifier> TrainLegs(const LegTrainingOptions& options,
                                              const Progress& say);

/// Looks for people in `scans` scans of a site with up to `most_four_legged` chairs and tables
/// around the robot.
PeopleFigures MeasureLegs(perception::LegFinder& finder, const Site& site, int scans,
                          int most_four_legged, std::uint64_t seed);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_LEG_TRAINING_H_
