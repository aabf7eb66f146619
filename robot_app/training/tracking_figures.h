// How well a crowd is followed, from the simulated lidar to the tracks.
#ifndef COPPICE_ROBOT_APP_TRAINING_TRACKING_FIGURES_H_
#define COPPICE_ROBOT_APP_TRAINING_TRACKING_FIGURES_H_

#include <string>

#include "robot_app/perception/clouds/people_finder.h"
#include "robot_app/perception/tracking/clear_mot.h"
#include "robot_app/perception/tracking/tracker.h"

namespace coppice::robot::training {

struct TrackingScenario {
  int people = 10;
  double seconds = 60;
  double turning = 0.2;  ///< of the robot on its place, and its sensor [rad/s]
  std::uint64_t seed = 1;
};

struct TrackingFigures {
  perception::ClearMot mot;  ///< within 5 m; who is hidden by more than 70 % is optional
  double person_minutes = 0;
  double seconds = 0;  ///< of calculation
  int turns = 0;       ///< of the lidar
  double switches_per_person_minute() const {
    return person_minutes > 0 ? mot.switches / person_minutes : 0;
  }
};

/// Ten people in a hall of 12 m with two columns walk around the robot, cross, stop, meet and hide
/// behind each other.
TrackingFigures MeasureTracking(perception::PeopleFinder& finder, const TrackingScenario& scenario);

/// A sentence or two for people.
std::string Summary(const TrackingFigures& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_TRACKING_FIGURES_H_
