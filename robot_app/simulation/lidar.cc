#include "robot_app/simulation/lidar.h"

#include <limits>

namespace coppice::robot::simulation {

Lidar::Lidar(const LidarOptions& options, std::uint64_t seed)
    : options_(options), random_(seed), noise_(0.0, 1.0) {
  scan_.angle_min = -options.field_of_view / 2;
  scan_.angle_step = options.field_of_view / (options.beams - 1);
}

void Lidar::Measure(double time, const Pose2& base, const RayCaster& still,
                    const std::vector<Disc>& moving, const Ground& ground) {
  const Pose2 laser = Compose(base, options_.mounting);
  scan_.time = time;
  scan_.ranges.resize(options_.beams);
  for (int i = 0; i < options_.beams; ++i) {
    const Vec2 direction = Direction(laser.yaw + scan_.angle_min + i * scan_.angle_step);
    double range = still.Cast(laser.position(), direction, options_.max_range);
    for (const Disc& disc : moving) {
      range = CastAtDisc(disc, laser.position(), direction, range);
    }
    range = ground.Cast(laser.position(), direction, options_.height, range);
    const double measured = range + options_.noise * noise_(random_);
    scan_.ranges[i] = range >= options_.max_range
                          ? std::numeric_limits<float>::infinity()
                          : static_cast<float>(std::max(measured, options_.min_range));
  }
}

}  // namespace coppice::robot::simulation
