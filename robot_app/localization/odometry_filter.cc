#include "robot_app/localization/odometry_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace coppice::robot::localization {
namespace {

constexpr double kMostSpeed = 20;   // no robot on a floor is faster [m/s]
constexpr double kMostTurn = 50;    // [rad/s]
constexpr double kLateness = 0.2;   // a message that was overtaken is still used [s]
constexpr double kSetBack = 1;      // one so old was not overtaken: time itself was set back [s]
constexpr double kLongestGap = 10;  // after a longer one the speeds are unknown anyway [s]

bool Possible(const Velocity2D& velocity) {  // false for NaN
  return std::abs(velocity.linear) < kMostSpeed && std::abs(velocity.angular) < kMostTurn;
}

double Square(double value) { return value * value; }

}  // namespace

bool OdometryFilter::Accepts(double stamp) const {
  return std::isfinite(stamp) && (!started_ || stamp > stamp_ - kLateness);
}

bool OdometryFilter::AddWheels(double stamp, const Pose2D& pose, const Velocity2D& velocity) {
  if (started_ && stamp < stamp_ - kSetBack) *this = OdometryFilter(settings_);
  if (!Accepts(stamp) || !Possible(velocity)) return false;
  if (!started_) {
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.yaw)) return false;
    started_ = true;
    stamp_ = stamp;
    state_ << pose.x, pose.y, pose.yaw, velocity.linear, velocity.angular;
  }
  Predict(stamp);
  wheels_stamp_ = stamp_;
  const double moving = std::abs(velocity.linear) + std::abs(velocity.angular);
  Correct<2>({velocity.linear, velocity.angular}, 3,
             {Square(settings_.speed_noise + settings_.speed_slip * moving),
              Square(settings_.turn_noise + settings_.turn_slip * moving)});
  return true;
}

bool OdometryFilter::AddYawRate(double stamp, double yaw_rate, double variance) {
  if (!started_ || !Accepts(stamp) || !Possible({0, yaw_rate})) return false;
  Predict(stamp);
  using One = Eigen::Matrix<double, 1, 1>;
  const bool told = variance > 0 && std::isfinite(variance);
  Correct<1>(One(yaw_rate), 4, One(told ? variance : Square(settings_.gyro_noise)));
  return true;
}

void OdometryFilter::Predict(double stamp) {
  const double dt = std::clamp(stamp - stamp_, 0.0, kLongestGap);
  stamp_ = std::max(stamp_, stamp);
  if (dt == 0) return;
  const Velocity2D speed = velocity();
  const double heading = state_(2) + speed.angular * dt / 2;
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  const double way = speed.linear * dt;

  Matrix jacobian = Matrix::Identity();
  jacobian(0, 2) = -way * s;
  jacobian(1, 2) = way * c;
  jacobian(0, 3) = dt * c;
  jacobian(1, 3) = dt * s;
  jacobian(0, 4) = -way * s * dt / 2;
  jacobian(1, 4) = way * c * dt / 2;
  jacobian(2, 4) = dt;

  state_(0) += way * c;
  state_(1) += way * s;
  state_(2) = NormalizeAngle(state_(2) + speed.angular * dt);

  covariance_ = jacobian * covariance_ * jacobian.transpose();
  const double moved = std::abs(speed.linear) * dt;
  const double turned = std::abs(speed.angular) * dt;
  covariance_(0, 0) += Square(settings_.drift) * moved;
  covariance_(1, 1) += Square(settings_.drift) * moved;
  covariance_(2, 2) += Square(settings_.yaw_drift) * (moved + turned);
  covariance_(3, 3) += Square(settings_.acceleration) * dt;
  covariance_(4, 4) += Square(settings_.turn_acceleration) * dt;
}

// Measured are the components of the state from `first` on.
template <int N>
void OdometryFilter::Correct(const Eigen::Matrix<double, N, 1>& measured, int first,
                             const Eigen::Matrix<double, N, 1>& variance) {
  using Square = Eigen::Matrix<double, N, N>;
  const Eigen::Matrix<double, 5, N> cross = covariance_.middleCols<N>(first);
  Square expected = covariance_.block<N, N>(first, first);
  expected.diagonal() += variance;
  const Square inverse = expected.inverse();
  const Eigen::Matrix<double, N, 1> difference = measured - state_.segment<N>(first);
  innovation_ = difference.dot(inverse * difference);
  const Eigen::Matrix<double, 5, N> gain = cross * inverse;
  state_ += gain * difference;
  covariance_ -= gain * cross.transpose();
  covariance_ = (covariance_ + covariance_.transpose().eval()) / 2;  // against rounding
}

}  // namespace coppice::robot::localization
