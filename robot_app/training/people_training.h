// Learns to tell people in clouds from all else, from simulated scans of random halls, and says how
// well people are found in scans of any site.
#ifndef COPPICE_ROBOT_APP_TRAINING_PEOPLE_TRAINING_H_
#define COPPICE_ROBOT_APP_TRAINING_PEOPLE_TRAINING_H_

#include <array>
#include <functional>
#include <string>

#include "robot_app/perception/clouds/people_finder.h"
#include "robot_app/training/labelled_scan.h"

namespace coppice::robot::training {

struct PeopleTrainingOptions {
  std::uint64_t seed = 1;
  int scans = 700;  ///< of a round, each in a hall of its own
  int rounds = 3;   ///< each after the first learns also from what the one before took for people
  perception::PersonClassifier::Training trees;
};

/// `say` is told how far it is, 0..1. The same options give the same classifier.
Expected<perception::PersonClassifier> TrainPeople(const PeopleTrainingOptions& options,
                                                   const std::function<void(double)>& say);

/// How many people were there, and how many of them were not found.
struct Misses {
  int people = 0;
  int missed = 0;
  double share() const { return people > 0 ? static_cast<double>(missed) / people : 0; }
};

enum class Distance { kNear, kMiddle, kFar };         ///< up to 5 m, 10 m, 20 m
enum class Occlusion { kFree, kHalfHidden, kGroup };  ///< in full view; 30-70 %; groups of three

struct PeopleFigures {
  int scans = 0;
  std::array<std::array<Misses, 3>, 3> misses;  ///< by Distance, then Occlusion
  std::array<int, 3> false_people{};            ///< by Distance
  double position_error = 0;                    ///< root of mean square within 5 m [m]
  double seconds = 0;                           ///< to find people, all scans

  const Misses& of(Distance distance, Occlusion occlusion) const {
    return misses[static_cast<std::size_t>(distance)][static_cast<std::size_t>(occlusion)];
  }
  double false_per_scan() const;
};

/// Looks for people in `scans` scans of a site. Who is hidden by more than 70 % counts neither as
/// missed nor as false.
PeopleFigures MeasurePeople(perception::PeopleFinder& finder, const Site& site, int scans,
                            std::uint64_t seed);

/// A table for people, Markdown.
std::string Table(const PeopleFigures& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_PEOPLE_TRAINING_H_
