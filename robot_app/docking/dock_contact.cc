// DockController: the charging current, other attempts, and the way out of the station.
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot_app/docking/dock_controller.h"
#include "robot_app/docking/dock_text.h"

namespace coppice::robot::docking {
namespace {

using Phase = DockController::Phase;

constexpr double kGoneFor = 10.0;    // the current must have stopped by then [s]
constexpr double kBackAhead = 0.35;  // of the pursuit backwards [m]
constexpr double kLane = 0.3;        // aside, before the station [m]
constexpr double kAlongLane = 0.6;   // rad

}  // namespace

Velocity2D DockController::WaitForCurrent(const DockInput& input) {
  velocity_ = {};
  if (!Charging(input)) {
    charging_since_ = -1;
    if (input.now - entered_ > settings_.charging_within) {
      if (!input.battery_known) return AttemptFailed(input, "the battery does not report");
      Enter(Phase::kPressOn, input);
      wiggle_.Start(input);
    }
    return velocity_;
  }
  if (charging_since_ < 0) charging_since_ = input.now;
  if (input.now - charging_since_ < settings_.charging_for) return velocity_;
  return Done(
      input.full ? Print("docked with a full battery at attempt %.0f", attempt_)
                 : Print("docked and charging with %.1f A at attempt %d", input.current, attempt_));
}

Velocity2D DockController::PressOn(const DockInput& input) {
  velocity_ = wiggle_.Update(input);
  if (wiggle_.active()) return velocity_;
  if (wiggle_.succeeded()) return Done(wiggle_.message());
  ++failed_contacts_;
  if (attempt_ > 0) return AttemptFailed(input, wiggle_.message());
  return Fail(wiggle_.message());
}

Velocity2D DockController::AttemptFailed(const DockInput& input, std::string why) {
  why_failed_ = std::move(why);
  ++failed_attempts_;
  path_.reset();
  has_failed_ = true;
  if (!StandsInTheWay(input)) return NextAttempt(input);
  Enter(Phase::kBackOut, input);
  return velocity_;
}

// Before the contacts, from where it can only back out.
bool DockController::StandsInTheWay(const DockInput& input) const {
  if (!input.seen) return false;  // it has not driven anywhere
  const Pose2D in_station = InStation(input);
  const double way_out =
      attempt_ < attempts_ ? settings_.retry_distance : settings_.staging_distance;
  return in_station.x > -way_out && std::abs(in_station.y) < kLane &&
         std::abs(in_station.yaw) < kAlongLane;
}

Velocity2D DockController::NextAttempt(const DockInput& input) {
  has_failed_ = false;
  has_staged_ = false;
  ways_round_ = 0;
  if (attempt_ >= attempts_) {
    return Fail(Print("%.0f attempts failed; the last one: ", attempt_) + why_failed_);
  }
  ++attempt_;
  Enter(Phase::kLook, input);
  return velocity_;
}

// How far it backs off: out of the station's way, but for another attempt only as far as that
// needs.
double DockController::WayOut() const {
  const bool tries_again = phase_ == Phase::kBackOut && (!has_failed_ || attempt_ < attempts_);
  return tries_again ? settings_.retry_distance : settings_.staging_distance;
}

Velocity2D DockController::HasBackedOff(const DockInput& input) {
  if (has_failed_) return NextAttempt(input);
  Enter(phase_ == Phase::kUndock ? Phase::kCheckCurrentGone : Phase::kLook, input);
  return velocity_;
}

// Along the station's axis.
Velocity2D DockController::BackOff(const DockInput& input, double seconds) {
  const Pose2D in_station = InStation(input);
  const double left = WayOut() + in_station.x;
  if (left < 0.02) return HasBackedOff(input);
  if (Stalled(input) || IsLate(input)) {
    if (has_failed_ && attempt_ < attempts_) return NextAttempt(input);
    return Fail(Print("the robot is stuck on the way off the station, %.2f m to go", left) +
                (why_failed_.empty() ? "" : "; before: " + why_failed_));
  }
  const double speed = std::max(
      0.04, std::min(settings_.back_speed, std::sqrt(0.5 * settings_.acceleration * left)));
  return Pursue(RelativeTo(in_station, Point2D{in_station.x - kBackAhead, 0}), -speed, seconds);
}

Velocity2D DockController::CheckCurrentGone(const DockInput& input) {
  velocity_ = {};
  if (input.battery_known && !Charging(input)) return Done("off the station");
  if (input.now - entered_ > kGoneFor) {
    return Fail(input.battery_known ? "off the station, but the battery still reports charging"
                                    : "off the station, but the battery does not report");
  }
  return velocity_;
}

}  // namespace coppice::robot::docking
