// The robot and people at random places of a site, for the scans that classifiers learn from.
#ifndef COPPICE_ROBOT_APP_TRAINING_PLACED_PEOPLE_H_
#define COPPICE_ROBOT_APP_TRAINING_PLACED_PEOPLE_H_

#include <random>
#include <vector>

#include "robot_app/simulation/scene/figure.h"
#include "robot_app/training/random_hall.h"

namespace coppice::robot::training {

struct PlacedPerson {
  simulation::Stance stance;
  bool in_group = false;  ///< two others stand within 0.8 m
};

struct PlacedPeople {
  simulation::Pose2 robot;  ///< base_link on the floor of the site
  std::vector<PlacedPerson> people;
};

/// Up to ten people who stand or walk, alone, in groups of three, and before each other, around a
/// robot on the free floor. The same state of `random` gives the same people.
PlacedPeople PlacePeople(const Site& site, std::mt19937_64& random);

std::vector<simulation::Figure> FiguresOf(const PlacedPeople& people);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_PLACED_PEOPLE_H_
