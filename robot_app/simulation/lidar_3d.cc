#include "robot_app/simulation/lidar_3d.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace coppice::robot::simulation {
namespace {

constexpr double kBrightest = 100;  // intensity of a diffuse white surface; more is a reflector
constexpr double kSlack = 1e-6;     // columns; time is a sum of steps

}  // namespace

std::vector<double> RingSlopes(const Lidar3dOptions& options) {
  const double step = -2 * options.lowest / (options.rings - 1);
  std::vector<double> slopes;
  for (int i = 0; i < options.rings; ++i) slopes.push_back(std::tan(options.lowest + i * step));
  return slopes;
}

Lidar3d::Lidar3d(const Lidar3dOptions& options, std::uint64_t seed)
    : options_(options), random_(seed), noise_(0.0, 1.0), slopes_(RingSlopes(options)) {}

void Lidar3d::Turn(double time, double dt, const Pose2& base, const Scene& scene) {
  const double before = turned_;
  turned_ += dt / options_.period * options_.columns;
  for (double column = std::ceil(before - kSlack); column < turned_ - kSlack; ++column) {
    const int place = static_cast<int>(column) % options_.columns;
    if (place == 0) {
      next_.points.clear();
      next_.time = time + (column - before) / options_.columns * options_.period;
    }
    MeasureColumn(place, base, scene);
    if (place == options_.columns - 1) std::swap(cloud_, next_);
  }
  if (turned_ >= options_.columns) turned_ -= options_.columns;
}

void Lidar3d::Restart() {
  turned_ = 0;
  next_.points.clear();
}

void Lidar3d::MeasureColumn(int column, const Pose2& base, const Scene& scene) {
  const Pose2 sensor = Compose(base, options_.mounting);
  const double angle = kPi - 2 * kPi * column / options_.columns;
  const Vec2 direction = Direction(angle);
  scene.CastFan({sensor.x, sensor.y, options_.height}, Rotated(direction, sensor.yaw), slopes_,
                options_.max_range, hits_);
  const auto time = static_cast<float>(options_.period * column / options_.columns);
  for (std::size_t ring = 0; ring < slopes_.size(); ++ring) {
    const Hit& hit = hits_[ring];
    const double noise = options_.noise * noise_(random_);
    const double steepness = std::hypot(1, slopes_[ring]);
    const double range = hit.range + noise / steepness;
    CloudPoint& point = next_.points.emplace_back();
    point.ring = static_cast<std::uint16_t>(ring);
    point.time = time;
    if (!(range < options_.max_range) || range * steepness < options_.min_range) {
      point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    point.x = static_cast<float>(range * direction.x);
    point.y = static_cast<float>(range * direction.y);
    point.z = static_cast<float>(range * slopes_[ring]);
    point.intensity = static_cast<float>(std::round(kBrightest * hit.reflectivity));
  }
}

}  // namespace coppice::robot::simulation
