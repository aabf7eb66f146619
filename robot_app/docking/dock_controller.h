// Drives onto the charging station and off it again.
//
// Docking: look for the station's landmark (station_tracker.h), plan a way into the station
// (dock_path.h), turn to it, follow it by pure pursuit (R. C. Coulter: Implementation of the Pure
// Pursuit Path Tracking Algorithm, CMU-RI-TR-92-01), slowly on the last metre, stand, and watch the
// battery. The path moves with the station as it is seen; where the robot has left it, it plans
// anew. Only a charging current that lasts is success, or a charger that says the battery is full:
// standing in the station is not. Without it the robot presses on and draws back a little
// (contact_wiggle.h), then backs out and tries again, a little to one side and then to the other.
// What stands in the way is waited for; who stands between the robot and the station, and perhaps
// cannot get past it, is let out. Where no way is free from where the robot stands, it drives to
// the staging pose first. Without the landmark it does not drive into anything.
// Undocking: straight back, then see that the current has stopped.
//
// A deterministic state machine without a clock, a thread or ROS. All poses in the odometry frame.
#ifndef COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_
#define COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_

#include <cstdint>
#include <optional>
#include <string>

#include "robot_app/docking/contact_wiggle.h"
#include "robot_app/docking/dock_path.h"
#include "robot_app/docking/dock_types.h"

namespace coppice::robot::docking {

class DockController {
 public:
  enum class Phase : std::uint8_t {
    kIdle,
    kLook,
    kTurnToStaging,
    kDriveToStaging,
    kTurnToPath,
    kFollowPath,
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
  /// The way that is followed, in the frame of the station; nothing while there is none.
  const std::optional<DockPath>& path() const { return path_; }
  /// base_link when docked, as far as this manoeuvre knows.
  const std::optional<Pose2D>& station() const { return station_; }
  /// base_link at the staging pose; nothing as long as the station is not known.
  std::optional<Pose2D> staging() const;

 private:
  void Enter(Phase phase, const DockInput& input);
  Velocity2D Stand();
  Velocity2D Fail(std::string message);
  Velocity2D Done(std::string message);

  // dock_approach.cc: the way into the station
  Velocity2D Look(const DockInput& input, double seconds);
  Velocity2D TurnTowards(const DockInput& input, double seconds);
  Velocity2D Plan(const DockInput& input);
  Velocity2D NoWay(const DockInput& input);
  Velocity2D TurnToStaging(const DockInput& input, double seconds);
  Velocity2D DriveToStaging(const DockInput& input, double seconds);
  Velocity2D TurnToPath(const DockInput& input, double seconds);
  Velocity2D FollowPath(const DockInput& input, double seconds);
  Velocity2D WaitOrGoRound(const DockInput& input);
  bool OnLastStretch() const;
  bool CanStage(const DockInput& input) const;
  Velocity2D DriveOut(const DockInput& input, double distance);
  bool IsToMakeWay(const DockInput& input, double waited) const;
  Velocity2D MakeWay(const DockInput& input);
  Pose2D Stage(const DockInput& input) const;
  Velocity2D ArriveOrGiveUp(const DockInput& input, const Pose2D& in_station);
  bool IsHeld(const DockInput& input, const Pose2D& in_station);
  double HeldFor(const DockInput& input);
  void DrivesOn(const DockInput& input);

  // dock_contact.cc: the current, and the way out
  Velocity2D WaitForCurrent(const DockInput& input);
  Velocity2D PressOn(const DockInput& input);
  Velocity2D BackOff(const DockInput& input, double seconds);
  Velocity2D HasBackedOff(const DockInput& input);
  Velocity2D CheckCurrentGone(const DockInput& input);
  Velocity2D AttemptFailed(const DockInput& input, std::string why);
  bool StandsInTheWay(const DockInput& input) const;
  Velocity2D NextAttempt(const DockInput& input);
  double WayOut() const;

  bool Charging(const DockInput& input) const;
  bool Stalled(const DockInput& input);
  bool IsLate(const DockInput& input) const;
  Velocity2D Turn(double angle, double seconds);
  Velocity2D Pursue(const Point2D& carrot, double speed, double seconds);
  double Offset() const;
  Pose2D Landmark() const { return LandmarkOf(settings_.landmark, *station_); }
  Pose2D InStation(const DockInput& input) const { return RelativeTo(*station_, input.pose); }

  DockSettings settings_;
  ContactWiggle wiggle_;
  Phase phase_ = Phase::kIdle;
  std::string message_;
  std::string why_failed_;  // the last attempt
  int failed_attempts_ = 0;
  int failed_contacts_ = 0;  // attempts that made no contact
  int ways_round_ = 0;       // that it has taken in this attempt
  int attempt_ = 0;
  int attempts_ = 0;               // at most
  double offset_ = 0;              // of the first attempt [m]
  bool has_failed_ = false;        // the attempt under way: it backs out for another one
  bool has_staged_ = false;        // in this attempt
  bool has_made_way_ = false;      // in this manoeuvre
  double stage_at_ = 0;            // so far before the docked pose [m]
  std::optional<Pose2D> station_;  // base_link when docked
  std::optional<DockPath> path_;   // in the frame of the station
  double along_ = 0;               // how far on it [m]
  double entered_ = 0;             // when the phase began
  double last_update_ = -1;
  double last_plan_ = -1;
  double charging_since_ = -1;  // negative: not charging
  double held_since_ = -1;      // by an obstacle; negative: not held
  Pose2D held_at_;              // at that time
  double moving_since_ = 0;     // stall detection: here the robot was ...
  Pose2D moving_from_;          // ... at that time
  Velocity2D velocity_;
};

/// "looking for the landmark", ...
const char* ToString(DockController::Phase phase);

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_DOCK_CONTROLLER_H_
