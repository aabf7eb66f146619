// The frame of the state machine; what it does in its phases: dock_approach.cc, dock_contact.cc.
#include "robot_app/docking/dock_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot_app/docking/dock_text.h"

namespace coppice::robot::docking {
namespace {

using Phase = DockController::Phase;

constexpr double kStallTime = 1.5;     // s
constexpr double kStallWay = 0.02;     // m in that time
constexpr double kNearContact = 0.08;  // standing this near, it may be docked already [m]
constexpr double kNotAtStation = 1.0;  // farther from the docked pose: nothing to undock from [m]

}  // namespace

const char* ToString(Phase phase) {
  switch (phase) {
    case Phase::kIdle:
      return "idle";
    case Phase::kLook:
      return "looking for the landmark";
    case Phase::kTurnToStaging:
      return "turning to the staging pose";
    case Phase::kDriveToStaging:
      return "driving to the staging pose";
    case Phase::kTurnToPath:
      return "turning to its way";
    case Phase::kFollowPath:
      return "driving in";
    case Phase::kWaitForCurrent:
      return "waiting for the charging current";
    case Phase::kPressOn:
      return "pressing on";
    case Phase::kBackOut:
      return "backing out";
    case Phase::kUndock:
      return "driving off";
    case Phase::kCheckCurrentGone:
      return "checking that charging has stopped";
    case Phase::kDone:
      return "done";
    case Phase::kFailed:
      return "failed";
  }
  return "";
}

bool DockController::active() const {
  return phase_ != Phase::kIdle && phase_ != Phase::kDone && phase_ != Phase::kFailed;
}

std::optional<Pose2D> DockController::staging() const {
  if (!station_) return std::nullopt;
  return Compose(*station_, Pose2D{-settings_.staging_distance, 0, 0});
}

// As wanted; where that made no contact, to the left of it, then to the right, and again.
double DockController::Offset() const {
  if (failed_contacts_ == 0) return offset_;
  return offset_ + (failed_contacts_ % 2 == 1 ? settings_.retry_offset : -settings_.retry_offset);
}

bool DockController::Charging(const DockInput& input) const { return IsServed(input, settings_); }

void DockController::Enter(Phase phase, const DockInput& input) {
  phase_ = phase;
  entered_ = input.now;
  charging_since_ = -1;
  held_since_ = -1;
  moving_since_ = input.now;
  moving_from_ = input.pose;
  velocity_ = {};
}

Velocity2D DockController::Stand() {
  velocity_ = {};
  return velocity_;
}

Velocity2D DockController::Fail(std::string message) {
  phase_ = Phase::kFailed;
  message_ = std::move(message);
  return Stand();
}

Velocity2D DockController::Done(std::string message) {
  phase_ = Phase::kDone;
  message_ = std::move(message);
  return Stand();
}

void DockController::StartDocking(const DockInput& input, double offset, int attempts) {
  *this = DockController(settings_);
  offset_ = offset;
  attempts_ = attempts > 0 ? attempts : settings_.attempts;
  attempt_ = 1;
  station_ = StationIn(input);
  if (Charging(input) && StandsInStation(input, kNearContact)) {
    if (!input.seen) station_ = input.pose;
    Enter(Phase::kWaitForCurrent, input);
    return;
  }
  if (station_) {
    const double away = Distance(input.pose, *staging());
    const double to_station = Distance(input.pose, *station_);
    if (away > settings_.farthest_start && to_station > settings_.staging_distance) {
      Fail(Print("the robot is %.2f m from the staging pose, too far for docking", away));
      return;
    }
  }
  Enter(Phase::kLook, input);
}

void DockController::StartUndocking(const DockInput& input) {
  *this = DockController(settings_);
  attempt_ = 1;
  station_ = input.docked && !input.seen ? input.pose : StationIn(input);
  if (Charging(input) && !station_) station_ = input.pose;
  const bool near = station_ && Distance(input.pose, *station_) < kNotAtStation;
  if (!Charging(input) && !input.docked && !near) {
    Done("the robot was not docked");
    return;
  }
  Enter(Phase::kUndock, input);
}

void DockController::StartPressingOn(const DockInput& input) {
  *this = DockController(settings_);
  station_ = StationIn(input);
  Enter(Phase::kPressOn, input);
  wiggle_.Start(input);
}

void DockController::Cancel() {
  phase_ = Phase::kIdle;
  message_ = "cancelled";
  velocity_ = {};
}

Velocity2D DockController::Update(const DockInput& input) {
  const double seconds = last_update_ < 0 ? 0 : std::clamp(input.now - last_update_, 0.0, 0.2);
  last_update_ = input.now;
  if (input.seen) station_ = input.seen->docked;
  switch (phase_) {
    case Phase::kLook:
      return Look(input, seconds);
    case Phase::kTurnToStaging:
      return TurnToStaging(input, seconds);
    case Phase::kDriveToStaging:
      return DriveToStaging(input, seconds);
    case Phase::kTurnToPath:
      return TurnToPath(input, seconds);
    case Phase::kFollowPath:
      return FollowPath(input, seconds);
    case Phase::kWaitForCurrent:
      return WaitForCurrent(input);
    case Phase::kPressOn:
      return PressOn(input);
    case Phase::kBackOut:
    case Phase::kUndock:
      return BackOff(input, seconds);
    case Phase::kCheckCurrentGone:
      return CheckCurrentGone(input);
    case Phase::kIdle:
    case Phase::kDone:
    case Phase::kFailed:
      return {};
  }
  return {};
}

Velocity2D DockController::Turn(double angle, double seconds) {
  const double speed = std::clamp(std::sqrt(settings_.turn_acceleration * std::abs(angle)), 0.08,
                                  settings_.turn_speed);
  velocity_.linear = LimitChange(velocity_.linear, 0, settings_.acceleration, seconds);
  velocity_.angular = LimitChange(velocity_.angular, std::copysign(speed, angle),
                                  settings_.turn_acceleration, seconds);
  return velocity_;
}

// To the point `carrot`, given in base_link; driving backwards it lies behind the robot.
Velocity2D DockController::Pursue(const Point2D& carrot, double speed, double seconds) {
  const double curvature = 2 * carrot.y / (carrot.x * carrot.x + carrot.y * carrot.y);
  // No faster than it can turn.
  const double most = 0.9 * settings_.turn_speed / std::max(1e-6, std::abs(curvature));
  speed = std::clamp(speed, -most, most);
  velocity_.linear = LimitChange(velocity_.linear, speed, settings_.acceleration, seconds);
  velocity_.angular =
      std::clamp(curvature * velocity_.linear, -settings_.turn_speed, settings_.turn_speed);
  return velocity_;
}

bool DockController::Stalled(const DockInput& input) {
  if (velocity_.linear == 0 || Distance(input.pose, moving_from_) > kStallWay) {
    moving_from_ = input.pose;
    moving_since_ = input.now;
  }
  return input.now - moving_since_ > kStallTime;
}

bool DockController::IsLate(const DockInput& input) const {
  return input.now - entered_ > settings_.phase_timeout;
}

}  // namespace coppice::robot::docking
