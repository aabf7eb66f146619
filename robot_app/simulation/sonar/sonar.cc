#include "robot_app/simulation/sonar/sonar.h"

#include <limits>

namespace coppice::robot::simulation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kFans = 15;  // odd, so that one looks ahead
constexpr int kRays = 11;  // of a fan in the middle

}  // namespace

SonarsOptions ShippedSonars() {
  SonarsOptions sonars;
  sonars[0].mounting = {0.285, 0.165, kPi / 6};
  sonars[2].mounting = {0.285, -0.165, -kPi / 6};
  return sonars;
}

Sonar::Sonar(const SonarOptions& options, std::uint64_t seed)
    : options_(options), random_(seed), noise_(0.0, 1.0) {
  const double half = options.field_of_view / 2;
  for (int i = 0; i < kFans; ++i) {
    Fan& fan = fans_.emplace_back();
    fan.angle = half * (2.0 * i / (kFans - 1) - 1);
    for (int k = 0; k < kRays; ++k) {
      const double up = half * (2.0 * k / (kRays - 1) - 1);
      if (std::hypot(fan.angle, up) <= half + 1e-9) fan.slopes.push_back(std::tan(up));
    }
  }
}

float Sonar::Measure(const Pose2& base, const Scene& scene) {
  const Pose2 sensor = Compose(base, options_.mounting);
  double nearest = kInfinity;
  for (const Fan& fan : fans_) nearest = std::min(nearest, NearestEcho(fan, sensor, scene));
  nearest += options_.noise * noise_(random_);
  if (nearest < options_.min_range) nearest = -kInfinity;
  if (nearest > options_.max_range) nearest = kInfinity;
  return static_cast<float>(nearest);
}

double Sonar::NearestEcho(const Fan& fan, const Pose2& sensor, const Scene& scene) {
  scene.CastFan({sensor.x, sensor.y, options_.height}, Direction(sensor.yaw + fan.angle),
                fan.slopes, options_.max_range, hits_);
  const double least_facing = std::cos(options_.steepest_echo);
  double nearest = kInfinity;
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    const double steepness = std::hypot(1, fan.slopes[i]);
    const bool echoes = hits_[i].facing >= least_facing * steepness;
    if (echoes) nearest = std::min(nearest, hits_[i].range * steepness);
  }
  return nearest;
}

}  // namespace coppice::robot::simulation
