#include "robot_app/localization/scan_matcher.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

namespace coppice::robot {
namespace {

constexpr double kSmallStep = 1e-4;  // the end of the iteration [m]

}  // namespace

Pose2D MatchScan(const LikelihoodField& field, const std::vector<Beam>& beams, const Pose2D& pose,
                 const MatchSettings& settings) {
  const double beam_weight = 1 / (settings.beam_noise * settings.beam_noise);
  const Eigen::Vector3d trust(1 / (settings.trust * settings.trust),
                              1 / (settings.trust * settings.trust),
                              1 / (settings.yaw_trust * settings.yaw_trust));
  Pose2D best = pose;
  for (int i = 0; i < settings.iterations; ++i) {
    Eigen::Matrix3d information = trust.asDiagonal();
    const Eigen::Vector3d moved(best.x - pose.x, best.y - pose.y,
                                NormalizeAngle(best.yaw - pose.yaw));
    Eigen::Vector3d pull = -trust.cwiseProduct(moved);
    for (const Beam& beam : beams) {
      if (!beam.hit) continue;
      const Point2D end = Compose(best, beam.to);
      const LikelihoodField::Slope slope = field.DistanceAndSlope(end.x, end.y);
      if (slope.distance > settings.outlier) continue;
      // The end moves with the position, and across its arm when the robot turns.
      const Eigen::Vector3d row(
          slope.along_x, slope.along_y,
          -slope.along_x * (end.y - best.y) + slope.along_y * (end.x - best.x));
      // Far from a wall an end counts less (Cauchy).
      const double off = slope.distance / settings.beam_noise;
      const double weight = beam_weight / (1 + off * off);
      information += weight * row * row.transpose();
      pull -= weight * slope.distance * row;
    }
    const Eigen::Vector3d step = information.ldlt().solve(pull);
    if (!step.allFinite()) break;
    best = {best.x + step(0), best.y + step(1), NormalizeAngle(best.yaw + step(2))};
    if (step.norm() < kSmallStep) break;
  }
  return best;
}

}  // namespace coppice::robot
