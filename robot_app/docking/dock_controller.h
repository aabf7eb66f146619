// Drives onto the charging station and off it again.
//
// Docking: turn to the staging pose and drive there, turn to the station, drive in slowly along the
// station's axis by pure pursuit (R. C. Coulter: Implementation of the Pure Pursuit Path Tracking
// Algorithm, CMU-RI-TR-92-01), stand, and watch the battery. Only a charging current that lasts is
// success, or a charger that says the battery is full: standing in the station is not. Without it
// the robot presses on and draws back a little (contact_wiggle.h), then backs out to the staging
// pose and tries again, a little to one side and then to the other.
// Undocking: straight back, then see that the current has stopped.
//
// A deterministic state machine without a clock, a thread or ROS. All poses in the map frame.
#ifndef COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_
#define COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_

#include <cstdint>
#include <string>

#include "robot_app/docking/contact_wiggle.h"
#include "robot_app/docking/dock_types.h"

namespace coppice::robot::docking {

class DockController {
 public:
  enum class Phase : std::uint8_t {
    kIdle,
    kTurnToStaging,
    kDriveToStaging,
    kTurnToStation,
    kApproach,
    kWaitForCurrent,
    kPressOn,
    kBackOut,
    kUndock,
    kCheckCurrentGone,
    kDone,
    kFailed
  };

  explicit DockController(DockSettings settings = {}) : settings_(settings), wiggle_(settings) {}

  /// Start a manoeuvre, replacing the one before. What is wrong with the request is told by
  /// kFailed after the next Update(). `offset`: of the approach, positive to the left of the
  /// station's axis [m]. `attempts`: 0 = those of the settings.
  void StartDocking(const DockInput& input, double offset = 0, int attempts = 0);
  void StartUndocking(const DockInput& input);
  /// Where the robot stands on the station without current; see contact_wiggle.h.
  void StartPressingOn(const DockInput& input);
  void Cancel();

  /// The next command for base_link. To be called at 10 Hz or more while active().
  Velocity2D Update(const DockInput& input);

  Phase phase() const { return phase_; }
  bool active() const;
  /// What came of it, for people.
  const std::string& message() const { return message_; }
  /// The attempt under way, from 1.
  int attempt() const { return attempt_; }
  /// Of this manoeuvre, and why the last one has.
  int failed_attempts() const { return failed_attempts_; }
  const std::string& why_failed() const { return why_failed_; }
  Pose2D staging() const;

 private:
  void Enter(Phase phase, const DockInput& input);
  Velocity2D Fail(std::string message);
  Velocity2D TurnToStaging(const DockInput& input, double seconds);
  Velocity2D DriveToStaging(const DockInput& input, double seconds);
  Velocity2D TurnToStation(const DockInput& input, double seconds);
  Velocity2D Approach(const DockInput& input, double seconds);
  Velocity2D WaitForCurrent(const DockInput& input);
  Velocity2D PressOn(const DockInput& input);
  Velocity2D BackOff(const DockInput& input, double seconds);
  Velocity2D CheckCurrentGone(const DockInput& input);
  Velocity2D AttemptFailed(const DockInput& input, std::string why);

  bool Charging(const DockInput& input) const;
  bool Stalled(const DockInput& input);
  Velocity2D Turn(double angle, double seconds);
  Velocity2D Pursue(const DockInput& input, double aside, double speed, double seconds);
  double Offset() const;

  DockSettings settings_;
  ContactWiggle wiggle_;
  Phase phase_ = Phase::kIdle;
  std::string message_;
  std::string why_failed_;  // the last attempt
  int failed_attempts_ = 0;
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

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_
