#include "robot_app/navigation/follower.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::navigation {
namespace {

constexpr double kStandingStill = 0.02;  // m/s and rad/s
constexpr double kTurnDoneBelow = 0.15;  // of a turn towards the path [rad]
constexpr double kCreep = 0.02;          // so little room is not driven: it would take for ever [m]

double NearestDistanceAhead(const std::vector<Point2D>& obstacles) {
  double nearest = HUGE_VAL;
  for (const Point2D& point : obstacles) {
    if (point.x > -0.1) nearest = std::min(nearest, std::hypot(point.x, point.y));
  }
  return nearest;
}

}  // namespace

double FreeDistance(const std::vector<Point2D>& obstacles, double curvature, double radius,
                    double limit) {
  constexpr double kStep = 0.04;
  constexpr double kNearer = 0.005;
  const double sign = limit < 0 ? -1 : 1;
  const double length = std::abs(limit);
  for (double gone = kStep; gone < length + kStep; gone += kStep) {
    const Pose2D there = Advance({}, {sign * gone, sign * gone * curvature}, 1);
    for (const Point2D& point : obstacles) {
      const double distance = std::hypot(point.x - there.x, point.y - there.y);
      if (distance >= radius) continue;
      if (distance < std::hypot(point.x, point.y) - kNearer) {
        return std::min(length, gone - kStep);
      }
    }
  }
  return length;
}

void Follower::SetPath(std::vector<Point2D> path, double goal_yaw) {
  path_ = std::move(path);
  goal_yaw_ = goal_yaw;
  nearest_ = 0;
}

void Follower::ClearPath() {
  path_.clear();
  turning_ = false;
  at_goal_ = false;
  tracking_error_ = 0;
}

void Follower::Reset() {
  ClearPath();
  velocity_ = {};
}

void Follower::FindNearest(const Pose2D& pose) {
  // Only a stretch ahead is searched: the path may come back near to itself.
  constexpr double kSearch = 1.5;
  const Point2D here{pose.x, pose.y};
  double best = Distance(path_[nearest_], here);
  double gone = 0;
  for (std::size_t i = nearest_ + 1; i < path_.size() && gone < kSearch; ++i) {
    gone += Distance(path_[i - 1], path_[i]);
    const double distance = Distance(path_[i], here);
    if (distance > best) continue;
    best = distance;
    nearest_ = i;
  }
  tracking_error_ = best;
}

Point2D Follower::Carrot(double lookahead) const {
  double gone = 0;
  std::size_t i = nearest_;
  while (i + 1 < path_.size() && gone < lookahead) {
    gone += Distance(path_[i], path_[i + 1]);
    ++i;
  }
  return path_[i];
}

double Follower::RemainingLength(const Pose2D& pose) const {
  double length = Distance(path_[nearest_], Point2D{pose.x, pose.y});
  for (std::size_t i = nearest_ + 1; i < path_.size(); ++i) {
    length += Distance(path_[i - 1], path_[i]);
  }
  return length;
}

void Follower::UpdateAtGoal(const Pose2D& pose) {
  const Point2D goal = RelativeTo(pose, path_.back());
  const double distance = std::hypot(goal.x, goal.y);
  if (at_goal_) {
    at_goal_ = distance < 0.95 * settings_.goal_tolerance;
  } else {
    const bool passed = goal.x < 0 && distance < 0.8 * settings_.goal_tolerance;
    at_goal_ = distance < settings_.goal_tolerance / 3 || passed;
  }
}

double Follower::SpeedLimit(const Pose2D& pose, const std::vector<Point2D>& obstacles,
                            double curvature) const {
  const FollowerSettings& s = settings_;
  double speed = std::min(s.max_speed, speed_limit_);
  const double bend = std::abs(curvature) * s.bend_radius;
  if (bend > 1) speed /= bend;
  const double gap = NearestDistanceAhead(obstacles) - s.robot_radius;
  if (gap < s.slow_within) {
    speed = std::min(speed, std::max(s.slow_to, s.max_speed * gap / s.slow_within));
  }
  // Braking distance to the goal, with some reserve for delays.
  const double approach = std::sqrt(2 * 0.6 * s.deceleration * RemainingLength(pose));
  return std::max(s.min_speed, std::min(speed, approach));
}

Velocity2D Follower::Brake(double seconds) {
  velocity_.linear = LimitChange(velocity_.linear, 0, settings_.deceleration, seconds);
  velocity_.angular = LimitChange(velocity_.angular, 0, 1.5 * settings_.turn_acceleration, seconds);
  return velocity_;
}

Velocity2D Follower::Turn(double angle, double seconds) {
  const double speed =
      std::min({settings_.max_turn, std::sqrt(settings_.turn_acceleration * std::abs(angle)),
                2 * std::abs(angle)});
  velocity_.linear = LimitChange(velocity_.linear, 0, settings_.deceleration, seconds);
  velocity_.angular = LimitChange(velocity_.angular, std::copysign(speed, angle),
                                  settings_.turn_acceleration, seconds);
  return velocity_;
}

Follower::Command Follower::TurnToGoal(const Pose2D& pose, double seconds) {
  const double angle = NormalizeAngle(goal_yaw_ - pose.yaw);
  if (std::abs(angle) > 0.6 * settings_.goal_yaw_tolerance) return {Turn(angle, seconds)};
  Command command{Brake(seconds)};
  command.reached =
      std::abs(velocity_.linear) < kStandingStill && std::abs(velocity_.angular) < kStandingStill;
  return command;
}

Follower::Command Follower::Update(const Pose2D& pose, const std::vector<Point2D>& obstacles,
                                   double seconds) {
  if (path_.empty()) return {Brake(seconds)};
  FindNearest(pose);
  UpdateAtGoal(pose);
  if (at_goal_) return TurnToGoal(pose, seconds);

  const FollowerSettings& s = settings_;
  const double lookahead =
      std::clamp(velocity_.linear * s.lookahead_time, s.min_lookahead, s.max_lookahead);
  const Point2D carrot = RelativeTo(pose, Carrot(lookahead));
  const double angle = std::atan2(carrot.y, carrot.x);
  turning_ = std::abs(angle) > (turning_ ? kTurnDoneBelow : s.turn_first_above);
  if (turning_) return {Turn(angle, seconds)};

  const double curvature = 2 * carrot.y / std::max(1e-4, carrot.x * carrot.x + carrot.y * carrot.y);
  double speed = SpeedLimit(pose, obstacles, curvature);
  // The arc is followed to the carrot; beyond it the path may bend away from what lies there.
  const double view = std::min(lookahead, RemainingLength(pose) + 0.05) + s.stop_distance;
  const double free = FreeDistance(obstacles, curvature, s.robot_radius + s.obstacle_margin, view);
  Command command;
  if (free < view) {
    const double room = std::max(0.0, free - s.stop_distance);
    speed =
        std::min({speed, std::sqrt(2 * 0.75 * s.deceleration * room), room / s.time_to_collision});
    command.obstacle = room < kCreep;
    if (command.obstacle) speed = 0;
  }
  const double limit = speed < velocity_.linear ? s.deceleration : s.acceleration;
  velocity_.linear = LimitChange(velocity_.linear, speed, limit, seconds);
  const double turn = std::clamp(curvature * velocity_.linear, -s.max_turn, s.max_turn);
  velocity_.angular = LimitChange(velocity_.angular, turn, 2 * s.turn_acceleration, seconds);
  command.velocity = velocity_;
  return command;
}

}  // namespace coppice::robot::navigation
