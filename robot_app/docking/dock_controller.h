// Drives onto the charging station and off it again.
//
// Docking: turn to the staging pose and drive there, turn to the station, drive in slowly along the
// station's axis by pure pursuit (R. C. Coulter: Implementation of the Pure Pursuit Path Tracking
// Algorithm, CMU-RI-TR-92-01), stand, and watch the battery. Only a charging current that lasts is
// success: standing in the station is not. Without it the robot backs out to the staging pose and
// tries again, a little to one side and then to the other.
// Undocking: straight back, then see that the current has stopped.
//
// A deterministic state machine without a clock, a thread or ROS. All poses in the map frame.
#ifndef COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_
#define COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "robot_app/navigation/pose2d.h"

namespace coppice::robot {

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
  int attempts = 3;
  double retry_offset = 0.03;      ///< aside, from the second attempt on [m]
  double phase_timeout = 40.0;     ///< no motion may take longer [s]
  double obstacle_patience = 8.0;  ///< waits this long for an obstacle to go [s]
  double robot_radius = 0.33;      ///< [m]
};

/// What the controller knows at one instant.
struct DockInput {
  double now = 0;                  ///< [s]
  Pose2D pose;                     ///< base_link
  double current = 0;              ///< of the battery, positive: charging [A]
  bool battery_known = true;       ///< the reading is not too old
  std::vector<Point2D> obstacles;  ///< laser points in base_link
};

class DockController {
 public:
  enum class Phase : std::uint8_t {
    kIdle,
    kTurnToStaging,
    kDriveToStaging,
    kTurnToStation,
    kApproach,
    kWaitForCurrent,
    kBackOut,
    kUndock,
    kCheckCurrentGone,
    kDone,
    kFailed
  };

  explicit DockController(DockSettings settings = {}) : settings_(settings) {}

  /// Start a manoeuvre, replacing the one before. What is wrong with the request is told by
  /// kFailed after the next Update(). `offset`: of the approach, positive to the left of the
  /// station's axis [m]. `attempts`: 0 = those of the settings.
  void StartDocking(const DockInput& input, double offset = 0, int attempts = 0);
  void StartUndocking(const DockInput& input);
  void Cancel();

  /// The next command for base_link. To be called at 10 Hz or more while active().
  Velocity2D Update(const DockInput& input);

  Phase phase() const { return phase_; }
  bool active() const;
  /// What came of it, for people.
  const std::string& message() const { return message_; }
  /// The attempt under way, from 1.
  int attempt() const { return attempt_; }
  Pose2D staging() const;

 private:
  void Enter(Phase phase, const DockInput& input);
  Velocity2D Fail(std::string message);
  Velocity2D TurnToStaging(const DockInput& input, double seconds);
  Velocity2D DriveToStaging(const DockInput& input, double seconds);
  Velocity2D TurnToStation(const DockInput& input, double seconds);
  Velocity2D Approach(const DockInput& input, double seconds);
  Velocity2D WaitForCurrent(const DockInput& input);
  Velocity2D BackOff(const DockInput& input, double seconds);
  Velocity2D CheckCurrentGone(const DockInput& input);
  Velocity2D AttemptFailed(const DockInput& input, std::string why);

  bool Charging(const DockInput& input) const;
  bool Stalled(const DockInput& input);
  Velocity2D Turn(double angle, double seconds);
  Velocity2D Pursue(const DockInput& input, double aside, double speed, double seconds);
  double Offset() const;

  DockSettings settings_;
  Phase phase_ = Phase::kIdle;
  std::string message_;
  std::string why_failed_;  // the last attempt
  int attempt_ = 0;
  int attempts_ = 0;    // at most
  double offset_ = 0;   // of the first attempt [m]
  double entered_ = 0;  // when the phase began
  double last_update_ = -1;
  double charging_since_ = -1;  // negative: not charging
  double held_since_ = -1;      // by an obstacle; negative: not held
  double moving_since_ = 0;     // stall detection: here the robot was ...
  Pose2D moving_from_;          // ... at that time
  Velocity2D velocity_;
};

/// "turning to the staging pose", ...
const char* ToString(DockController::Phase phase);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_
