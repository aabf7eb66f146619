#include "robot_app/simulation/odometry.h"

namespace coppice::robot::simulation {

Odometry::Odometry(const OdometryOptions& options, std::uint64_t seed)
    : options_(options),
      random_(seed),
      noise_(0.0, 1.0),
      metres_per_tick_(kPi * options.wheel_diameter / options.ticks_per_turn) {
  left_.scale = 1 + options.diameter_error * noise_(random_);
  right_.scale = 1 + options.diameter_error * noise_(random_);
}

void Odometry::Roll(Wheel& wheel, double way) {
  if (way == 0) return;
  wheel.way += way * wheel.scale + options_.slip * std::sqrt(std::abs(way)) * noise_(random_);
}

void Odometry::Move(double forward, double turn) {
  const double sideways = turn * options_.track / 2;
  Roll(left_, forward - sideways);
  Roll(right_, forward + sideways);
}

// The way since the last reading, in whole ticks.
double Odometry::ReadWheel(Wheel& wheel) {
  const auto ticks = static_cast<std::int64_t>(std::floor(wheel.way / metres_per_tick_));
  const double way = static_cast<double>(ticks - wheel.ticks) * metres_per_tick_;
  wheel.ticks = ticks;
  return way;
}

void Odometry::Read(double time) {
  const double left = ReadWheel(left_);
  const double right = ReadWheel(right_);
  const double forward = (left + right) / 2;
  const double turn = (right - left) / options_.track;
  pose_ = Compose(pose_, {forward * std::cos(turn / 2), forward * std::sin(turn / 2), turn});
  const double dt = time - time_;
  if (dt > 0) velocity_ = {forward / dt, turn / dt};
  time_ = time;
}

void Imu::Measure(double dt, const Velocity& before, const Velocity& after) {
  constexpr double kGravity = 9.81;
  reading_.yaw_rate = after.angular + kYawRateNoise * noise_(random_);
  reading_.acceleration_x =
      (after.linear - before.linear) / dt + kAccelerationNoise * noise_(random_);
  reading_.acceleration_y = after.linear * after.angular + kAccelerationNoise * noise_(random_);
  reading_.acceleration_z = kGravity + kAccelerationNoise * noise_(random_);
}

}  // namespace coppice::robot::simulation
