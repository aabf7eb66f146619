// Rooms that nobody built: walls, furniture and things that look like people from afar, drawn from
// a seed. What is learnt in them is tested on floors that it has never seen.
#ifndef COPPICE_ROBOT_APP_TRAINING_RANDOM_HALL_H_
#define COPPICE_ROBOT_APP_TRAINING_RANDOM_HALL_H_

#include <random>

#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/scene/scene.h"

namespace coppice::robot::training {

/// A place to measure in: what stands there, and the part of the floor that is looked at.
struct Site {
  simulation::StillScene still;
  simulation::Rectangle area;
};

/// A hall of 8 to 24 m with some partition walls, desks, cupboards, chairs, columns, plants, coat
/// racks and boxes of a person's size.
Site MakeRandomHall(std::mt19937_64& random);

/// A floor as it is at the start: the rectangle around its walls is looked at.
Site SiteOf(const simulation::Floor& floor);

/// Whether a thing of this radius can stand at `point` without touching anything, inside the walls.
bool IsFree(const Site& site, simulation::Vec2 point, double radius);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_RANDOM_HALL_H_
