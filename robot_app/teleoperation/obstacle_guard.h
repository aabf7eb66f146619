// Keeps a person who drives by the camera from driving into what the laser sees.
#ifndef COPPICE_ROBOT_APP_TELEOPERATION_OBSTACLE_GUARD_H_
#define COPPICE_ROBOT_APP_TELEOPERATION_OBSTACLE_GUARD_H_

#include <vector>

#include "robot_app/common/footprint.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::teleoperation {

struct GuardSettings {
  double robot_radius = kRobotRadius;  ///< [m]
  double stop_distance = 0.35;         ///< kept from the edge of the robot to obstacles [m]
  double deceleration = 0.4;           ///< that the robot brakes with [m/s^2]
  double most_backwards = 0.15;        ///< where the laser does not look [m/s]
  double look_ahead = 2.0;             ///< along the way [m]
};

/// How far a round robot can drive along the arc of `command` until its edge touches one of
/// `obstacles` (base_link), at most `settings.look_ahead` [m]. What it touches already counts only
/// if the arc leads nearer to it.
double FreeWay(const Velocity2D& command, const std::vector<Point2D>& obstacles,
               const GuardSettings& settings);

/// The command, slowed down so that the robot can stop in time; zero forwards if it must not go on.
/// The shape of the arc stays; turning on the spot is always allowed.
Velocity2D Guard(const Velocity2D& command, const std::vector<Point2D>& obstacles,
                 const GuardSettings& settings);

}  // namespace coppice::robot::teleoperation

#endif  // COPPICE_ROBOT_APP_TELEOPERATION_OBSTACLE_GUARD_H_
