// How well a crowd is followed, from the simulated lidar and cameras to the tracks.
#ifndef COPPICE_ROBOT_APP_TRAINING_TRACKING_FIGURES_H_
#define COPPICE_ROBOT_APP_TRAINING_TRACKING_FIGURES_H_

#include <functional>
#include <string>

#include "robot_app/perception/clouds/people_finder.h"
#include "robot_app/perception/legs/leg_finder.h"
#include "robot_app/perception/tracking/clear_mot.h"
#include "robot_app/perception/tracking/tracker.h"
#include "robot_app/training/camera_pair.h"
#include "robot_app/training/random_hall.h"

namespace coppice::robot::training {

struct TrackingScenario {
  int people = 10;
  double seconds = 60;
  double turning = 0.2;  ///< of the robot on its place, and its sensor [rad/s]
  double delay = 0.25;   ///< until what is seen in a picture is told [s]
  std::uint64_t seed = 1;
  /// Called whenever somebody was looked for, with the time [s]; may be empty.
  std::function<void(double time, const perception::Tracker& tracker)> on_look;
};

/// The hall in which they walk; the robot stands in its middle.
Site TrackingHall();

/// What people are followed with; null: that sensor is dead.
struct Senses {
  perception::PeopleFinder* lidar = nullptr;
  CameraPair* cameras = nullptr;
  perception::LegFinder* legs = nullptr;  ///< in the scans of the planar laser, without the lidar
};

struct TrackingFigures {
  /// Within 5 m; who is hidden by more than 70 % is optional, and without the lidar who is not
  /// wholly within a picture or where the laser looks.
  perception::ClearMot mot;
  /// Without the lidar: also of those to whom nothing looks.
  perception::ClearMot all_round;
  double person_minutes = 0;
  double seconds = 0;  ///< of calculation
  int turns = 0;       ///< of the lidar, or scans of the laser, or pictures
  double switches_per_person_minute() const {
    return person_minutes > 0 ? mot.switches / person_minutes : 0;
  }
};

/// Ten people in a hall of 12 m with two columns walk around the robot, cross, stop, meet and hide
/// behind each other. The lidar gives the beat, or if it is dead the laser, else the cameras.
TrackingFigures MeasureTracking(const Senses& senses, const TrackingScenario& scenario);

/// A sentence or two for people.
std::string Summary(const TrackingFigures& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_TRACKING_FIGURES_H_
