#include "robot_app/navigation/relative_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "robot_app/navigation/follower.h"

namespace coppice::robot::navigation {
namespace {

constexpr double kCloseEnough = 0.01;   // m
constexpr double kTurnedEnough = 0.02;  // rad
constexpr double kSlowest = 0.03;       // m/s
constexpr double kLongestJump = 1;      // between two reports of the odometry [m]
constexpr double kSlowestTurn = 0.08;   // rad/s

std::string Print(const char* format, double a, double b) {
  char text[120];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

}  // namespace

void RelativeMotion::Start(const Pose2D& from, double distance, double angle, double speed,
                           const Velocity2D& velocity) {
  *this = RelativeMotion(settings_);
  if (!std::isfinite(distance) || !std::isfinite(angle) || !std::isfinite(speed) || speed < 0) {
    Fail("distance, angle and speed must be numbers, and the speed not negative");
    return;
  }
  if (distance < -settings_.longest_backwards) {
    Fail(Print("%.2f m backwards is too far without a rear sensor; at most %.2f m", -distance,
               settings_.longest_backwards));
    return;
  }
  state_ = State::kMoving;
  distance_ = distance;
  angle_ = angle;
  speed_ = speed;
  straight_ = distance != 0;
  remaining_ = straight_ ? std::abs(distance) : std::abs(angle);
  from_ = last_ = from;
  velocity_ = velocity;
  stopping_ = velocity.linear != 0 || velocity.angular != 0;
}

Velocity2D RelativeMotion::Fail(std::string message) {
  state_ = State::kFailed;
  message_ = std::move(message);
  velocity_ = {};
  return velocity_;
}

Velocity2D RelativeMotion::Update(const Pose2D& odometry, const std::vector<Point2D>& obstacles,
                                  double seconds) {
  if (state_ != State::kMoving) return {};
  if (!(Distance(last_, odometry) <= kLongestJump) || !std::isfinite(odometry.yaw - last_.yaw)) {
    return Fail("the odometry jumps");
  }
  const Velocity2D velocity = stopping_   ? Stop(odometry, seconds)
                              : straight_ ? Straight(odometry, obstacles, seconds)
                                          : Turn(odometry, seconds);
  last_ = odometry;
  return velocity;
}

Velocity2D RelativeMotion::Stop(const Pose2D& odometry, double seconds) {
  velocity_.linear = LimitChange(velocity_.linear, 0, settings_.deceleration, seconds);
  velocity_.angular = LimitChange(velocity_.angular, 0, settings_.turn_acceleration, seconds);
  stopping_ = velocity_.linear != 0 || velocity_.angular != 0;
  from_ = odometry;
  return velocity_;
}

bool RelativeMotion::Stalled(double moved, double commanded, double seconds) {
  stall_seconds_ += seconds;
  stall_moved_ += moved;
  stall_commanded_ += commanded;
  if (stall_seconds_ < settings_.stall_time) return false;
  const bool stalled = stall_moved_ < settings_.stall_share * stall_commanded_;
  stall_seconds_ = stall_moved_ = stall_commanded_ = 0;
  return stalled;
}

bool RelativeMotion::HeldTooLong(const std::vector<Point2D>& obstacles, double seconds,
                                 double& speed) {
  const double view = settings_.stop_distance + 0.5;
  const double room =
      FreeDistance(obstacles, 0, settings_.robot_radius, view) - settings_.stop_distance;
  speed = std::min(speed, std::sqrt(2 * 0.7 * settings_.acceleration * std::max(0.0, room)));
  const bool held = room < kCloseEnough;
  if (held) speed = 0;
  held_ = held ? held_ + seconds : 0;
  return held_ > settings_.obstacle_patience;
}

Velocity2D RelativeMotion::Straight(const Pose2D& odometry, const std::vector<Point2D>& obstacles,
                                    double seconds) {
  const double sign = distance_ < 0 ? -1 : 1;
  const Pose2D gone = RelativeTo(from_, odometry);
  remaining_ = std::abs(distance_) - sign * gone.x;
  if (remaining_ < kCloseEnough) {
    velocity_ = {};
    straight_ = false;
    remaining_ = std::abs(angle_);
    if (angle_ != 0) return velocity_;
    state_ = State::kDone;
    message_ = "done";
    return velocity_;
  }
  const double moved = sign * RelativeTo(last_, odometry).x;
  if (Stalled(moved, std::abs(velocity_.linear) * seconds, seconds)) {
    return Fail(Print("the wheels do not move the robot, %.2f m before the end", remaining_, 0));
  }
  double speed = std::min(speed_ > 0 ? speed_ : settings_.default_speed, settings_.max_speed);
  speed =
      std::min(speed, std::max(kSlowest, std::sqrt(2 * 0.7 * settings_.acceleration * remaining_)));
  if (sign > 0 && HeldTooLong(obstacles, seconds, speed)) {
    return Fail(Print("an obstacle is in the way, %.2f m before the end", remaining_, 0));
  }
  // Steer back to the straight line: the wheels are never quite equal.
  const double aside = -sign * 1.5 * gone.y - 1.5 * gone.yaw;
  velocity_.linear =
      speed == 0 ? 0 : LimitChange(velocity_.linear, sign * speed, settings_.acceleration, seconds);
  velocity_.angular =
      std::clamp(aside, -0.3, 0.3) * std::min(1.0, std::abs(velocity_.linear) / 0.1);
  return velocity_;
}

Velocity2D RelativeMotion::Turn(const Pose2D& odometry, double seconds) {
  const double step = NormalizeAngle(odometry.yaw - last_.yaw);
  turned_ += step;
  const double left = angle_ - turned_;
  remaining_ = std::abs(left);
  if (remaining_ < kTurnedEnough) {
    velocity_ = {};
    state_ = State::kDone;
    message_ = "done";
    return velocity_;
  }
  const double sign = left < 0 ? -1 : 1;
  if (Stalled(sign * step, std::abs(velocity_.angular) * seconds, seconds)) {
    return Fail(Print("the wheels do not turn the robot, %.2f rad before the end", remaining_, 0));
  }
  double speed = std::min(speed_ > 0 ? speed_ : settings_.default_turn, settings_.max_turn);
  speed = std::min(
      speed, std::max(kSlowestTurn, std::sqrt(2 * 0.6 * settings_.turn_acceleration * remaining_)));
  velocity_.linear = 0;
  velocity_.angular =
      LimitChange(velocity_.angular, sign * speed, settings_.turn_acceleration, seconds);
  return velocity_;
}

}  // namespace coppice::robot::navigation
