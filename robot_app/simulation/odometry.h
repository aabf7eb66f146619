// Wheel odometry and the inertial unit: how the robot measures its own motion, with its errors.
#ifndef COPPICE_ROBOT_APP_SIMULATION_ODOMETRY_H_
#define COPPICE_ROBOT_APP_SIMULATION_ODOMETRY_H_

#include <cstdint>
#include <random>

#include "robot_app/simulation/drive.h"
#include "robot_app/simulation/scene/geometry.h"

namespace coppice::robot::simulation {

struct OdometryOptions {
  double track = 0.56;            ///< between the wheels, m
  double wheel_diameter = 0.26;   ///< m
  double ticks_per_turn = 4096;   ///< of a wheel's encoder
  double diameter_error = 0.001;  ///< standard deviation of each wheel's scale, drawn once
  double slip = 0.002;            ///< standard deviation of the way after 1 m; grows with its root
  double period = 0.05;           ///< between two readings, s
};

/// Counts the ticks of both wheels and integrates them, as the robot's controller does.
class Odometry {
 public:
  Odometry(const OdometryOptions& options, std::uint64_t seed);

  /// The robot really moved `forward` metres and turned by `turn` radians.
  void Move(double forward, double turn);

  /// Reads the encoders at `time` seconds: moves pose() and velocity() on.
  void Read(double time);

  double time() const { return time_; }  ///< of the last reading
  /// Of base_link in the frame `odom`, which lies where the robot stood at the start.
  const Pose2& pose() const { return pose_; }
  const Velocity& velocity() const { return velocity_; }
  const OdometryOptions& options() const { return options_; }

 private:
  struct Wheel {
    double scale = 1;
    double way = 0;          // with slip, m
    std::int64_t ticks = 0;  // at the last reading
  };
  void Roll(Wheel& wheel, double way);
  double ReadWheel(Wheel& wheel);

  OdometryOptions options_;
  std::mt19937_64 random_;
  std::normal_distribution<double> noise_;
  double metres_per_tick_;
  Wheel left_;
  Wheel right_;
  double time_ = 0;
  Pose2 pose_;
  Velocity velocity_;
};

struct ImuReading {
  double yaw_rate = 0;        ///< rad/s
  double acceleration_x = 0;  ///< m/s^2, forward
  double acceleration_y = 0;  ///< m/s^2, to the left (centripetal)
  double acceleration_z = 0;  ///< m/s^2, up, with gravity
};

class Imu {
 public:
  static constexpr double kYawRateNoise = 0.002;      ///< rad/s
  static constexpr double kAccelerationNoise = 0.05;  ///< m/s^2

  explicit Imu(std::uint64_t seed) : random_(seed), noise_(0.0, 1.0) {}

  /// The velocity changed from `before` to `after` within `dt` seconds.
  void Measure(double dt, const Velocity& before, const Velocity& after);

  const ImuReading& reading() const { return reading_; }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> noise_;
  ImuReading reading_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_ODOMETRY_H_
