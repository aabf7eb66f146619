// Dockings drawn by lot, for a rate: random poses before the station, noise, worn wheels, a wrong
// idea of where the robot is, a station that somebody has moved, and passers-by.
#ifndef COPPICE_TESTS_ROBOT_APP_DOCKING_DOCKING_STUDY_H_
#define COPPICE_TESTS_ROBOT_APP_DOCKING_DOCKING_STUDY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::docking {

struct StudyOptions {
  double patience = 60;       ///< in which there must be current [s]
  bool moved = true;          ///< the station, by up to 0.5 m and 20 degrees
  bool passers_by = true;     ///< up to three
  bool steps_aside = true;    ///< they go round a robot that stands in their way
  double wheel_error = 0.01;  ///< standard deviation of a wheel's diameter, a share of it
};

struct DockingOutcome {
  bool docked = false;  ///< current flows within the patience
  int failed_attempts = 0;
  double seconds = 0;       ///< until current has lasted
  double aside = 0;         ///< off the contacts when it ended [m]
  double turned = 0;        ///< rad
  std::string message;      ///< of the controller
  Pose2D start;             ///< in the map
  Pose2D station_moved;     ///< as seen by a docked robot
  std::vector<Pose2D> way;  ///< of base_link, in the map
};

/// The same seed gives the same docking.
DockingOutcome DockOnce(std::uint64_t seed, const StudyOptions& options = {});

}  // namespace coppice::robot::docking

#endif  // COPPICE_TESTS_ROBOT_APP_DOCKING_DOCKING_STUDY_H_
