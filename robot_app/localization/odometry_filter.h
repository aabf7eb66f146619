// Odometry from wheels and gyroscope together: an extended Kalman filter in the plane.
//
// The state is x, y, yaw, forward speed and yaw rate; between measurements the robot keeps its
// speeds (a unicycle on an arc) and their uncertainty grows. Wheels measure both speeds, the
// gyroscope the yaw rate. S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics (2005), ch. 3.3;
// which quantities of which sensor are fused follows T. Moore, D. Stouch: A Generalized Extended
// Kalman Filter Implementation for the Robot Operating System (IAS-13, 2014): never a pose that is
// itself integrated from velocities that are fused.
//
// Deterministic, without a clock, a thread or ROS. Stamps in seconds of any one clock.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_ODOMETRY_FILTER_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_ODOMETRY_FILTER_H_

#include <Eigen/Core>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::localization {

struct OdometryFilterSettings {
  double acceleration = 0.2;       ///< change of speed in one second; grows with its root [m/s]
  double turn_acceleration = 0.5;  ///< [rad/s^2]
  double speed_noise = 0.004;      ///< of the wheels at rest, standard deviation [m/s]
  double speed_slip = 0.01;        ///< more of it for each m/s and each rad/s
  double turn_noise = 0.01;        ///< of the wheels at rest [rad/s]
  double turn_slip = 0.03;         ///< more of it for each m/s and each rad/s
  double gyro_noise = 0.002;       ///< if the message does not say it [rad/s]
  double drift = 0.015;            ///< of the position after one metre; grows with its root [m]
  double yaw_drift = 0.002;        ///< of the yaw after one metre or one radian [rad]
};

class OdometryFilter {
 public:
  using Vector = Eigen::Matrix<double, 5, 1>;  ///< x, y, yaw, forward speed, yaw rate
  using Matrix = Eigen::Matrix<double, 5, 5>;

  explicit OdometryFilter(OdometryFilterSettings settings = {}) : settings_(settings) {}

  /// The wheels report their own integrated pose and the velocity. The first report starts the
  /// filter at that pose, with no uncertainty: the origin of the odometry frame is wherever the
  /// wheels say it is, so that a restarted filter goes on near to where it was. A report that is
  /// more than a second older than what is known starts it anew. False if the report is not used:
  /// not finite, not possible for a robot on a floor, or older than what is known.
  bool AddWheels(double stamp, const Pose2D& pose, const Velocity2D& velocity);

  /// The gyroscope's yaw rate; `variance` 0: the setting counts. False if it is not used: as above,
  /// or the filter has not started.
  bool AddYawRate(double stamp, double yaw_rate, double variance);

  bool started() const { return started_; }
  /// Of the newest measurement; what follows is the estimate for that time.
  double stamp() const { return stamp_; }
  /// Of the newest report of the wheels. Without wheels the estimate soon means nothing.
  double wheels_stamp() const { return wheels_stamp_; }
  Pose2D pose() const { return {state_(0), state_(1), NormalizeAngle(state_(2))}; }
  Velocity2D velocity() const { return {state_(3), state_(4)}; }
  const Matrix& covariance() const { return covariance_; }
  /// Normalized innovation squared of the last measurement (Bar-Shalom): its mean is at most the
  /// number of measured values (2 for wheels, 1 for the gyroscope) if the noise is as set.
  double innovation() const { return innovation_; }

 private:
  bool Accepts(double stamp) const;
  void Predict(double stamp);
  template <int N>
  void Correct(const Eigen::Matrix<double, N, 1>& measured, int first,
               const Eigen::Matrix<double, N, 1>& variance);

  OdometryFilterSettings settings_;
  bool started_ = false;
  double stamp_ = 0;
  double wheels_stamp_ = 0;
  Vector state_ = Vector::Zero();
  Matrix covariance_ = Matrix::Zero();
  double innovation_ = 0;
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_ODOMETRY_FILTER_H_
