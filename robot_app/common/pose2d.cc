#include "robot_app/common/pose2d.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice::robot {

double NormalizeAngle(double angle) {
  const double turned = std::remainder(angle, 2 * M_PI);
  return turned <= -M_PI ? turned + 2 * M_PI : turned;
}

double Distance(const Pose2D& a, const Pose2D& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double Distance(const Point2D& a, const Point2D& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Point2D Compose(const Pose2D& frame, const Point2D& local) { return PointComposer(frame)(local); }

Pose2D Compose(const Pose2D& frame, const Pose2D& local) {
  const Point2D origin = Compose(frame, Point2D{local.x, local.y});
  return {origin.x, origin.y, NormalizeAngle(frame.yaw + local.yaw)};
}

Point2D RelativeTo(const Pose2D& frame, const Point2D& point) {
  const double c = std::cos(frame.yaw);
  const double s = std::sin(frame.yaw);
  const double dx = point.x - frame.x;
  const double dy = point.y - frame.y;
  return {c * dx + s * dy, -s * dx + c * dy};
}

Pose2D RelativeTo(const Pose2D& frame, const Pose2D& pose) {
  const Point2D origin = RelativeTo(frame, Point2D{pose.x, pose.y});
  return {origin.x, origin.y, NormalizeAngle(pose.yaw - frame.yaw)};
}

Pose2D Advance(const Pose2D& pose, const Velocity2D& velocity, double seconds) {
  const double turn = velocity.angular * seconds;
  const double length = velocity.linear * seconds;
  // The chord of the arc: sin(turn/2) / (turn/2) times its length, in the middle direction.
  const double half = turn / 2;
  const double chord = std::abs(half) < 1e-9 ? length : length * std::sin(half) / half;
  return {pose.x + chord * std::cos(pose.yaw + half), pose.y + chord * std::sin(pose.yaw + half),
          NormalizeAngle(pose.yaw + turn)};
}

double LimitChange(double current, double target, double acceleration, double seconds) {
  const double step = acceleration * seconds;
  return std::clamp(target, current - step, current + step);
}

std::optional<Point2D> ParsePlace(const std::string& text) {
  Point2D place;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf %lf %c", &place.x, &place.y, &rest) != 2 ||
      !std::isfinite(place.x + place.y)) {
    return std::nullopt;
  }
  return place;
}

std::optional<Pose2D> ParsePose(const std::string& text) {
  Pose2D pose;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf %lf %lf %c", &pose.x, &pose.y, &pose.yaw, &rest) != 3 ||
      !std::isfinite(pose.x + pose.y + pose.yaw)) {
    return std::nullopt;
  }
  return pose;
}

}  // namespace coppice::robot
