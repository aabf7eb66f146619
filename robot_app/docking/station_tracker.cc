#include "robot_app/docking/station_tracker.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace coppice::robot::docking {
namespace {

constexpr int kEnough = 3;          // scans, before it counts
constexpr double kFarOff = 1.2;     // from where it is expected; farther is another thing [m]
constexpr double kTurnedOff = 0.7;  // rad
constexpr double kGate = 16.3;      // squared Mahalanobis distance; 99.9 % of all sightings
constexpr int kMisses = 10;         // then it is looked for anew
// What the odometry drifts for each metre, and for each radian as seen at a metre, as variances.
constexpr double kDriftPlace = 1e-3;   // m^2/m
constexpr double kDriftYaw = 1e-3;     // rad^2/m
constexpr double kDriftTurn = 1e-3;    // rad^2/rad
constexpr double kModelPlace = 0.002;  // no landmark is built and no laser measures better [m]
constexpr double kModelYaw = 0.003;    // rad

Eigen::Matrix3d Turned(const Eigen::Matrix3d& covariance, double yaw) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(yaw), -std::sin(yaw), std::sin(yaw), std::cos(yaw);
  return turn * covariance * turn.transpose();
}

}  // namespace

void StationTracker::AddScan(const LaserScan& scan, const Pose2D& base,
                             const std::optional<Pose2D>& expected) {
  if (scans_ == 0) return Begin(scan, base, expected);
  Drift(base);
  const auto sighting = FitLandmark(scan, settings_, RelativeTo(base, corner_));
  if (sighting && Correct(*sighting, base)) {
    misses_ = 0;
    ++scans_;
    if (scans_ >= kEnough) Tell(scan.stamp);
    return;
  }
  // Hidden it may be as long as it likes; but it must not be seen elsewhere.
  ++misses_;
  if (misses_ < kMisses && scans_ >= kEnough) return;
  const int scans = scans_;
  Begin(scan, base, expected);
  if (scans_ == 0) scans_ = scans >= kEnough ? scans : 0;
}

// With the landmark that is nearest to where the station is expected, or to the robot.
void StationTracker::Begin(const LaserScan& scan, const Pose2D& base,
                           const std::optional<Pose2D>& expected) {
  scans_ = 0;
  double nearest = expected ? kFarOff : std::numeric_limits<double>::infinity();
  for (const LandmarkSighting& sighting : FindLandmarks(scan, settings_)) {
    const Pose2D corner = Compose(base, sighting.pose);
    const Pose2D docked = DockedAt(settings_.shape, corner);
    if (expected && std::abs(NormalizeAngle(docked.yaw - expected->yaw)) > kTurnedOff) continue;
    const double distance = Distance(docked, expected.value_or(base));
    if (distance > nearest) continue;
    nearest = distance;
    corner_ = corner;
    covariance_ = Turned(sighting.covariance, base.yaw);
    scans_ = 1;
  }
  if (scans_ == 0) return;
  base_ = base;
  misses_ = 0;
  seen_.reset();
}

void StationTracker::Drift(const Pose2D& base) {
  const double way = Distance(base, base_);
  const double turn = std::abs(NormalizeAngle(base.yaw - base_.yaw));
  const double away = Distance(base, corner_);
  const double yaw = kDriftYaw * way + kDriftTurn * turn;
  const double place = kDriftPlace * way + yaw * away * away;
  covariance_.diagonal() += Eigen::Vector3d(place, place, yaw);
  base_ = base;
}

bool StationTracker::Correct(const LandmarkSighting& sighting, const Pose2D& base) {
  const Pose2D corner = Compose(base, sighting.pose);
  const Eigen::Vector3d off(corner.x - corner_.x, corner.y - corner_.y,
                            NormalizeAngle(corner.yaw - corner_.yaw));
  Eigen::Matrix3d noise = Turned(sighting.covariance, base.yaw);
  noise.diagonal() +=
      Eigen::Vector3d(kModelPlace * kModelPlace, kModelPlace * kModelPlace, kModelYaw * kModelYaw);
  const Eigen::Matrix3d both = (covariance_ + noise).inverse();
  if (!both.allFinite() || off.dot(both * off) > kGate) return false;
  const Eigen::Matrix3d gain = covariance_ * both;
  const Eigen::Vector3d step = gain * off;
  corner_ = {corner_.x + step.x(), corner_.y + step.y(), NormalizeAngle(corner_.yaw + step.z())};
  covariance_ = (Eigen::Matrix3d::Identity() - gain) * covariance_;
  return true;
}

void StationTracker::Tell(double stamp) {
  seen_ = {DockedAt(settings_.shape, corner_), stamp, scans_,
           std::sqrt(std::max(covariance_(0, 0), covariance_(1, 1))), std::sqrt(covariance_(2, 2))};
}

}  // namespace coppice::robot::docking
