#include "robot_app/docking/dock_controller.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice::robot::docking {
namespace {

using Phase = DockController::Phase;

constexpr double kAtStaging = 0.06;    // near enough to the staging pose [m]
constexpr double kAligned = 0.02;      // rad
constexpr double kAtContact = 0.01;    // before the docked pose [m]
constexpr double kNearContact = 0.08;  // standing still here means contact [m]
constexpr double kNoticeAhead = 0.4;   // obstacles nearer than this to the rim hold the robot [m]
constexpr double kStallTime = 1.5;     // s
constexpr double kStallWay = 0.02;     // m in that time
constexpr double kGoneFor = 10.0;      // the current must have stopped by then [s]
constexpr double kNotAtStation = 1.0;  // farther from the docked pose: nothing to undock from [m]

std::string Print(const char* format, double value, int a = 0) {
  char text[160];
  std::snprintf(text, sizeof text, format, value, a);
  return text;
}

}  // namespace

const char* ToString(Phase phase) {
  switch (phase) {
    case Phase::kIdle:
      return "idle";
    case Phase::kTurnToStaging:
      return "turning to the staging pose";
    case Phase::kDriveToStaging:
      return "driving to the staging pose";
    case Phase::kTurnToStation:
      return "turning to the station";
    case Phase::kApproach:
      return "driving in";
    case Phase::kWaitForCurrent:
      return "waiting for the charging current";
    case Phase::kPressOn:
      return "pressing on";
    case Phase::kBackOut:
      return "backing out for another attempt";
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

Pose2D DockController::staging() const {
  return Compose(settings_.docked, Pose2D{-settings_.staging_distance, 0, 0});
}

double DockController::Offset() const {
  // As wanted, then to the left of it, then to the right, and again.
  if (attempt_ <= 1) return offset_;
  return offset_ + (attempt_ % 2 == 0 ? settings_.retry_offset : -settings_.retry_offset);
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

Velocity2D DockController::Fail(std::string message) {
  phase_ = Phase::kFailed;
  message_ = std::move(message);
  velocity_ = {};
  return velocity_;
}

void DockController::StartDocking(const DockInput& input, double offset, int attempts) {
  *this = DockController(settings_);
  offset_ = offset;
  attempts_ = attempts > 0 ? attempts : settings_.attempts;
  attempt_ = 1;
  if (Distance(input.pose, settings_.docked) < kNearContact && Charging(input)) {
    Enter(Phase::kWaitForCurrent, input);
    return;
  }
  const double away = Distance(input.pose, staging());
  const bool inside = RelativeTo(settings_.docked, input.pose).x > -settings_.staging_distance &&
                      Distance(input.pose, settings_.docked) <= settings_.staging_distance;
  if (away > settings_.farthest_start && !inside) {
    Fail(Print("the robot is %.2f m from the staging pose, too far for docking", away));
    return;
  }
  // Between staging pose and station a robot that faces the station drives straight out first.
  const bool faces_it = std::abs(RelativeTo(settings_.docked, input.pose).yaw) < 0.6;
  if (inside && faces_it && away > kAtStaging) {
    attempt_ = 0;  // that is not an attempt yet
    Enter(Phase::kBackOut, input);
  } else {
    Enter(Phase::kTurnToStaging, input);
  }
}

void DockController::StartUndocking(const DockInput& input) {
  *this = DockController(settings_);
  attempt_ = 1;
  if (!Charging(input) && Distance(input.pose, settings_.docked) > kNotAtStation) {
    phase_ = Phase::kDone;
    message_ = "the robot was not docked";
    return;
  }
  Enter(Phase::kUndock, input);
}

void DockController::StartPressingOn(const DockInput& input) {
  *this = DockController(settings_);
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
  switch (phase_) {
    case Phase::kTurnToStaging:
      return TurnToStaging(input, seconds);
    case Phase::kDriveToStaging:
      return DriveToStaging(input, seconds);
    case Phase::kTurnToStation:
      return TurnToStation(input, seconds);
    case Phase::kApproach:
      return Approach(input, seconds);
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

Velocity2D DockController::TurnToStaging(const DockInput& input, double seconds) {
  const Pose2D goal = RelativeTo(input.pose, staging());
  const double away = std::hypot(goal.x, goal.y);
  const double angle = std::atan2(goal.y, goal.x);
  if (away < kAtStaging) {
    Enter(Phase::kTurnToStation, input);
  } else if (std::abs(angle) < 0.05) {
    Enter(Phase::kDriveToStaging, input);
  } else if (input.now - entered_ > settings_.phase_timeout) {
    return Fail("cannot turn to the staging pose");
  } else {
    return Turn(angle, seconds);
  }
  return velocity_;
}

Velocity2D DockController::DriveToStaging(const DockInput& input, double seconds) {
  const Pose2D goal = RelativeTo(input.pose, staging());
  const double away = std::hypot(goal.x, goal.y);
  const double angle = std::atan2(goal.y, goal.x);
  if (away < kAtStaging) {
    Enter(Phase::kTurnToStation, input);
    return velocity_;
  }
  if (std::abs(angle) > 1) {  // passed at the side
    Enter(Phase::kTurnToStaging, input);
    return velocity_;
  }
  if (input.now - entered_ > settings_.phase_timeout) {
    return Fail(Print("cannot reach the staging pose, %.2f m before it", away));
  }
  const bool held =
      std::any_of(input.obstacles.begin(), input.obstacles.end(), [&](const Point2D& point) {
        return std::abs(point.y) < settings_.robot_radius && point.x > 0 &&
               std::hypot(point.x, point.y) < settings_.robot_radius + 0.12;
      });
  const double speed =
      held ? 0 : std::min(settings_.align_speed, std::sqrt(settings_.acceleration * away));
  velocity_.linear =
      held ? 0 : LimitChange(velocity_.linear, speed, settings_.acceleration, seconds);
  velocity_.angular = std::clamp(1.5 * angle, -settings_.turn_speed, settings_.turn_speed);
  return velocity_;
}

Velocity2D DockController::TurnToStation(const DockInput& input, double seconds) {
  const double angle = RelativeTo(input.pose, settings_.docked).yaw;
  if (std::abs(angle) < kAligned) {
    Enter(Phase::kApproach, input);
    return velocity_;
  }
  if (input.now - entered_ > settings_.phase_timeout) return Fail("cannot turn to the station");
  return Turn(angle, seconds);
}

Velocity2D DockController::Pursue(const DockInput& input, double aside, double speed,
                                  double seconds) {
  // The axis of the station, moved aside: pursue the point `lookahead` farther along it. Driving
  // backwards it lies behind the robot.
  const Pose2D in_station = RelativeTo(settings_.docked, input.pose);
  const double sign = speed < 0 ? -1 : 1;
  const Point2D carrot =
      RelativeTo(in_station, Point2D{in_station.x + sign * settings_.lookahead, aside});
  const double curvature = 2 * carrot.y / (carrot.x * carrot.x + carrot.y * carrot.y);
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

Velocity2D DockController::Approach(const DockInput& input, double seconds) {
  const double left = -RelativeTo(settings_.docked, input.pose).x;
  const bool stalled = Stalled(input);
  if (left < kAtContact || (stalled && left < kNearContact) || Charging(input)) {
    Enter(Phase::kWaitForCurrent, input);
    return velocity_;
  }
  if (stalled) {
    return AttemptFailed(input, Print("the robot is stuck %.2f m before the station", left));
  }
  if (input.now - entered_ > settings_.phase_timeout) {
    return AttemptFailed(input, "driving in takes too long");
  }
  // Whatever stands on the way and clearly before the station.
  const bool held =
      std::any_of(input.obstacles.begin(), input.obstacles.end(), [&](const Point2D& point) {
        const double gap = point.x - settings_.robot_radius;
        return std::abs(point.y) < settings_.robot_radius && point.x > 0 && gap < kNoticeAhead &&
               gap < left - 0.1;
      });
  if (held) {
    if (held_since_ < 0) held_since_ = input.now;
    if (input.now - held_since_ > settings_.obstacle_patience) {
      return AttemptFailed(input, "an obstacle stands before the station");
    }
    velocity_ = {};
    return velocity_;
  }
  held_since_ = -1;
  const double speed = std::max(
      0.03, std::min(settings_.approach_speed, std::sqrt(0.5 * settings_.acceleration * left)));
  return Pursue(input, Offset(), speed, seconds);
}

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
  phase_ = Phase::kDone;
  message_ = input.full
                 ? Print("docked with a full battery at attempt %.0f", attempt_)
                 : Print("docked and charging with %.1f A at attempt %d", input.current, attempt_);
  return velocity_;
}

Velocity2D DockController::PressOn(const DockInput& input) {
  velocity_ = wiggle_.Update(input);
  if (wiggle_.active()) return velocity_;
  velocity_ = {};
  message_ = wiggle_.message();
  if (wiggle_.succeeded()) {
    phase_ = Phase::kDone;
  } else if (attempt_ > 0) {
    return AttemptFailed(input, message_);
  } else {
    phase_ = Phase::kFailed;
  }
  return velocity_;
}

Velocity2D DockController::AttemptFailed(const DockInput& input, std::string why) {
  why_failed_ = std::move(why);
  ++failed_attempts_;
  Enter(Phase::kBackOut, input);
  return velocity_;
}

Velocity2D DockController::BackOff(const DockInput& input, double seconds) {
  const double left = settings_.staging_distance + RelativeTo(settings_.docked, input.pose).x;
  if (left < 0.02) {
    if (phase_ == Phase::kUndock) {
      Enter(Phase::kCheckCurrentGone, input);
    } else if (attempt_ >= attempts_) {
      return Fail(Print("%.0f attempts failed; the last one: ", attempt_) + why_failed_);
    } else {
      ++attempt_;
      Enter(Phase::kTurnToStaging, input);
    }
    return velocity_;
  }
  if (Stalled(input) || input.now - entered_ > settings_.phase_timeout) {
    return Fail(Print("the robot is stuck on the way off the station, %.2f m to go", left) +
                (why_failed_.empty() ? "" : "; before: " + why_failed_));
  }
  const double speed = std::max(
      0.04, std::min(settings_.back_speed, std::sqrt(0.5 * settings_.acceleration * left)));
  return Pursue(input, 0, -speed, seconds);
}

Velocity2D DockController::CheckCurrentGone(const DockInput& input) {
  velocity_ = {};
  if (input.battery_known && !Charging(input)) {
    phase_ = Phase::kDone;
    message_ = "off the station";
  } else if (input.now - entered_ > kGoneFor) {
    return Fail(input.battery_known ? "off the station, but the battery still reports charging"
                                    : "off the station, but the battery does not report");
  }
  return velocity_;
}

}  // namespace coppice::robot::docking
