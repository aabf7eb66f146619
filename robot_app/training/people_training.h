// Learns to tell people in clouds from all else, from simulated scans of random halls, and says how
// well people are found in scans of any site.
#ifndef COPPICE_ROBOT_APP_TRAINING_PEOPLE_TRAINING_H_
#define COPPICE_ROBOT_APP_TRAINING_PEOPLE_TRAINING_H_

#include "robot_app/perception/clouds/people_finder.h"
#include "robot_app/training/learning_rounds.h"
#include "robot_app/training/people_figures.h"

namespace coppice::robot::training {

/// The same options give the same classifier.
Expected<perception::PersonClassifier> TrainPeople(const LearningRounds& learning,
                                                   const Progress& say);

/// Looks for people in `scans` scans of a site. Who is hidden by more than 70 % counts neither as
/// missed nor as false.
PeopleFigures MeasurePeople(perception::PeopleFinder& finder, const Site& site, int scans,
                            std::uint64_t seed);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_PEOPLE_TRAINING_H_
