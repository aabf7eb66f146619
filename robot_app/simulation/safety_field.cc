#include "robot_app/simulation/safety_field.h"

namespace coppice::robot::simulation {
namespace {

constexpr int kBeams = 61;
constexpr double kFieldOfView = kPi;

}  // namespace

double FrontGap(const Pose2& base, const Pose2& mounting, double radius, double reach,
                const RayCaster& still, const std::vector<Disc>& moving) {
  const Pose2 laser = Compose(base, mounting);
  const double max_range = radius + reach;
  double gap = reach;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = -kFieldOfView / 2 + i * kFieldOfView / (kBeams - 1);
    const Vec2 direction = Direction(laser.yaw + angle);
    double range = still.Cast(laser.position(), direction, max_range);
    for (const Disc& disc : moving) {
      range = CastAtDisc(disc, laser.position(), direction, range);
    }
    if (range >= max_range) continue;
    const Vec2 point = mounting.position() + Direction(mounting.yaw + angle) * range;
    if (std::abs(point.y) >= radius) continue;  // beside the way
    gap = std::min(gap, point.x - std::sqrt(radius * radius - point.y * point.y));
  }
  return gap;
}

}  // namespace coppice::robot::simulation
