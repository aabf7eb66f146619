#include "robot_app/teleoperation/obstacle_guard.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::teleoperation {
namespace {

constexpr double kStep = 0.04;    // [m]
constexpr double kNearer = 1e-3;  // [m]

}  // namespace

double FreeWay(const Velocity2D& command, const std::vector<Point2D>& obstacles,
               const GuardSettings& settings) {
  const double speed = std::abs(command.linear);
  if (speed == 0) return settings.look_ahead;
  const Point2D origin{};
  for (double way = kStep; way <= settings.look_ahead; way += kStep) {
    const Pose2D pose = Advance({}, command, way / speed);
    for (const Point2D& obstacle : obstacles) {
      const double distance = Distance(Point2D{pose.x, pose.y}, obstacle);
      if (distance < settings.robot_radius && distance < Distance(origin, obstacle) - kNearer) {
        return way - kStep;
      }
    }
  }
  return settings.look_ahead;
}

Velocity2D Guard(const Velocity2D& command, const std::vector<Point2D>& obstacles,
                 const GuardSettings& settings) {
  if (command.linear == 0) return command;
  const double room = FreeWay(command, obstacles, settings) - settings.stop_distance;
  double most = room > 0 ? std::sqrt(2 * settings.deceleration * room) : 0;
  if (command.linear < 0) most = std::min(most, settings.most_backwards);
  if (most == 0) return {0, command.angular};
  const double share = std::min(1.0, most / std::abs(command.linear));
  return {command.linear * share, command.angular * share};
}

}  // namespace coppice::robot::teleoperation
