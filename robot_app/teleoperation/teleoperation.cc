#include "robot_app/teleoperation/teleoperation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::robot::teleoperation {
namespace {

double Clamped(double value, double most) {
  return std::isfinite(value) ? std::clamp(value, -most, most) : 0;
}

}  // namespace

bool Teleoperation::Take(std::uint64_t client, const std::string& name, bool take_over, Time now) {
  if (driver_ != 0 && driver_ != client && !take_over) return false;
  if (driver_ != client) wish_ = {};
  must_release_ = false;
  driver_ = client;
  name_ = name;
  used_at_ = now;
  return true;
}

void Teleoperation::Leave(std::uint64_t client) {
  if (driver_ != client) return;
  driver_ = 0;
  name_.clear();
  held_.clear();
  wish_ = {};
  must_release_ = true;
}

void Teleoperation::Drive(std::uint64_t client, const Velocity2D& wish, Time seen, Time now) {
  if (client != driver_ || client == 0) return;
  is_late_ = seen > now || now - seen > settings_.most_delay;
  wish_ = is_late_ ? Velocity2D{} : Limited(wish);
  wished_at_ = now;
  used_at_ = now;
}

void Teleoperation::SetObstacles(std::vector<Point2D> points, Time now) {
  obstacles_ = std::move(points);
  obstacles_at_ = now;
}

std::optional<Velocity2D> Teleoperation::Command(Time now) {
  if (driver_ != 0 && now - used_at_ >= settings_.idle) Leave(driver_);
  if (driver_ == 0) {
    if (!std::exchange(must_release_, false)) return std::nullopt;
    return Velocity2D{};
  }
  held_.clear();
  if (now - wished_at_ >= settings_.dead_man) {
    wish_ = {};
  } else if (is_late_) {
    held_ = "The connection is too slow to drive.";
  }
  if (wish_.linear == 0) return wish_;
  if (now - obstacles_at_ >= settings_.scan_lifetime) {
    held_ = "The laser is silent: the robot only turns.";
    return Velocity2D{0, wish_.angular};
  }
  const Velocity2D command = Guard(wish_, obstacles_, settings_.guard);
  if (command.linear == 0) held_ = "Something stands in the way.";
  return command;
}

Velocity2D Teleoperation::Limited(const Velocity2D& wish) const {
  return {Clamped(wish.linear, settings_.most_linear),
          Clamped(wish.angular, settings_.most_angular)};
}

}  // namespace coppice::robot::teleoperation
