// What the manoeuvres at the charging station are told: the station, the robot's ways, and what is
// known at one instant. All poses in the map frame.
#ifndef COPPICE_ROBOT_APP_DOCKING_DOCK_TYPES_H_
#define COPPICE_ROBOT_APP_DOCKING_DOCK_TYPES_H_

#include <cmath>
#include <vector>

#include "robot_app/common/footprint.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::docking {

struct DockSettings {
  Pose2D docked{-2.40, 0, M_PI};   ///< base_link when docked
  double staging_distance = 1.6;   ///< from there back to the staging pose [m]
  double farthest_start = 1.5;     ///< from the staging pose; else docking is refused [m]
  double approach_speed = 0.12;    ///< into the station [m/s]
  double back_speed = 0.15;        ///< out of it [m/s]
  double align_speed = 0.25;       ///< to the staging pose [m/s]
  double turn_speed = 0.5;         ///< [rad/s]
  double acceleration = 0.3;       ///< [m/s^2]
  double turn_acceleration = 1.0;  ///< [rad/s^2]
  double lookahead = 0.35;         ///< of the pursuit [m]
  double charging_above = 0.5;     ///< a current into the battery counts from here on [A]
  double charging_for = 3.0;       ///< and must last this long [s]
  double charging_within = 10.0;   ///< beginning no later than this after contact [s]
  double wiggle_way = 0.05;        ///< pressing on and drawing back [m]
  double wiggle_speed = 0.04;      ///< m/s
  double wiggle_wait = 4.0;        ///< for the current, after each move [s]
  int attempts = 3;
  double retry_offset = 0.03;          ///< aside, from the second attempt on [m]
  double phase_timeout = 40.0;         ///< no motion may take longer [s]
  double obstacle_patience = 8.0;      ///< waits this long for an obstacle to go [s]
  double robot_radius = kRobotRadius;  ///< [m]
};

/// What a controller knows at one instant.
struct DockInput {
  double now = 0;                  ///< [s]
  Pose2D pose;                     ///< base_link
  double current = 0;              ///< of the battery, positive: charging [A]
  bool battery_known = true;       ///< the reading is not too old
  bool docked = false;             ///< the charger says that the contacts touch
  bool full = false;               ///< the charger says that it needs no more current
  std::vector<Point2D> obstacles;  ///< laser points in base_link
};

/// Charging current flows, or the charger says that none is needed.
inline bool IsServed(const DockInput& input, const DockSettings& settings) {
  return input.battery_known && (input.full || input.current > settings.charging_above);
}

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_DOCK_TYPES_H_
