#include "robot_app/knowledge/answers/real_way.h"

#include <cmath>
#include <limits>

namespace coppice::robot::knowledge {
namespace {

constexpr double kDetour = 2;  // of ways that nobody has drawn
constexpr double kPace = 0.5;  // m/s

}  // namespace

WayTo RealWay(const RouteGuide& guide, const Pose2D& robot) {
  return [&guide, robot](const Place& place) {
    const int index = guide.map().Find(place.id);
    const auto route = index < 0 ? std::nullopt : guide.Whole(robot, index, Time{});
    if (route) return route->cost;
    const auto& at = place.position.at;
    if (!at) return std::numeric_limits<double>::infinity();
    return kDetour * std::hypot(at->x - robot.x, at->y - robot.y) / kPace;
  };
}

}  // namespace coppice::robot::knowledge
