// What the manoeuvres at the charging station are told: the robot's ways, and what is known at one
// instant.
#ifndef COPPICE_ROBOT_APP_DOCKING_DOCK_TYPES_H_
#define COPPICE_ROBOT_APP_DOCKING_DOCK_TYPES_H_

#include <optional>
#include <vector>

#include "robot_app/common/footprint.h"
#include "robot_app/common/places/landmark_shape.h"
#include "robot_app/common/pose2d.h"
#include "robot_app/docking/station_tracker.h"

namespace coppice::robot::docking {

struct DockSettings {
  LandmarkShape landmark;          ///< what the station is recognized by
  double staging_distance = 1.6;   ///< of the staging pose before the docked one [m]
  double way_distance = 2.6;       ///< the same of where it makes way for somebody [m]
  double retry_distance = 1.0;     ///< backs out so far for another attempt [m]
  double farthest_start = 2.5;     ///< from the staging pose; else docking is refused [m]
  double approach_speed = 0.12;    ///< on the last metre into the station [m/s]
  double back_speed = 0.15;        ///< out of it [m/s]
  double align_speed = 0.25;       ///< before the last metre [m/s]
  double turn_speed = 0.5;         ///< [rad/s]
  double turn_radius = 0.45;       ///< of the path's arcs [m]
  double acceleration = 0.3;       ///< [m/s^2]
  double turn_acceleration = 1.0;  ///< [rad/s^2]
  double lookahead = 0.25;         ///< of the pursuit [m]
  double last_lookahead = 0.15;    ///< of the pursuit on the last stretch [m]
  double look_for = 6.0;           ///< the landmark, from where it should be in sight [s]
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

/// What a controller knows at one instant. Poses in the frame of the odometry, which drifts but
/// does not jump.
struct DockInput {
  double now = 0;                       ///< [s]
  Pose2D pose;                          ///< base_link
  double current = 0;                   ///< of the battery, positive: charging [A]
  bool battery_known = true;            ///< the reading is not too old
  bool docked = false;                  ///< the charger says that the contacts touch
  bool full = false;                    ///< the charger says that it needs no more current
  std::vector<Point2D> obstacles;       ///< laser points in base_link
  std::optional<StationSighting> seen;  ///< the station, by its landmark
  std::optional<Pose2D> expected;       ///< base_link when docked, as the map has it
};

/// Charging current flows, or the charger says that none is needed.
inline bool IsServed(const DockInput& input, const DockSettings& settings) {
  return input.battery_known && (input.full || input.current > settings.charging_above);
}

/// Where base_link is when docked, as well as it is known.
inline std::optional<Pose2D> StationIn(const DockInput& input) {
  return input.seen ? std::optional(input.seen->docked) : input.expected;
}

/// The contacts touch, or by what is seen they could.
inline bool StandsInStation(const DockInput& input, double reach) {
  return input.docked || (input.seen && Distance(input.pose, input.seen->docked) < reach);
}

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_DOCK_TYPES_H_
