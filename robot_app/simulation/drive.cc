#include "robot_app/simulation/drive.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::simulation {
namespace {

constexpr double kReactionTime = 0.05;  // of the safety circuit, s

double Limit(double value, double limit) {
  return std::isfinite(value) ? std::clamp(value, -limit, limit) : 0.0;
}

double Approach(double value, double target, double most) {
  return value + std::clamp(target - value, -most, most);
}

}  // namespace

void Drive::Command(double time, const Velocity& command) {
  command_ = {Limit(command.linear, options_.max_linear),
              Limit(command.angular, options_.max_angular)};
  command_time_ = time;
}

double Drive::ProtectiveField(double speed) const {
  const double forward = std::max(speed, 0.0);
  return options_.protective_distance + forward * kReactionTime +
         forward * forward / (2 * options_.protective_braking);
}

Velocity Drive::Next(double time, double dt, const Velocity& actual, double front_gap,
                     bool powered) {
  const bool fresh = time - command_time_ <= options_.command_timeout + 1e-9;
  const Velocity target = fresh && powered ? command_ : Velocity{};
  Velocity next;
  next.angular = Approach(actual.angular, target.angular, options_.angular_acceleration * dt);
  next.linear = Approach(actual.linear, target.linear, options_.linear_acceleration * dt);
  protective_stop_ = next.linear > 0 && front_gap < ProtectiveField(next.linear);
  if (protective_stop_) {
    next.linear =
        Approach(actual.linear, std::min(target.linear, 0.0), options_.protective_braking * dt);
    next.linear = std::max(next.linear, 0.0);
    if (front_gap < options_.protective_distance) next.linear = 0;
  }
  return next;
}

}  // namespace coppice::robot::simulation
