#include "robot_app/localization/scan_matcher.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

namespace coppice::robot::localization {
namespace {

constexpr double kSmallStep = 1e-4;  // the end of the iteration [m]

// The normal equations of one step of Gauss-Newton.
struct Equations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
};

Equations OfBeams(const LikelihoodField& field, const std::vector<Beam>& beams, const Pose2D& pose,
                  const MatchSettings& settings) {
  const double beam_weight = 1 / (settings.beam_noise * settings.beam_noise);
  const PointComposer in_map(pose);
  Equations sum;
  for (const Beam& beam : beams) {
    if (!beam.hit) continue;
    const Point2D end = in_map(beam.to);
    const LikelihoodField::Slope slope = field.DistanceAndSlope(end.x, end.y);
    if (slope.distance > settings.outlier) continue;
    // The end moves with the position, and across its arm when the robot turns.
    const Eigen::Vector3d row(slope.along_x, slope.along_y,
                              -slope.along_x * (end.y - pose.y) + slope.along_y * (end.x - pose.x));
    // Far from a wall an end counts less (Cauchy).
    const double off = slope.distance / settings.beam_noise;
    const double weight = beam_weight / (1 + off * off);
    sum.information += weight * row * row.transpose();
    sum.pull -= weight * slope.distance * row;
  }
  return sum;
}

}  // namespace

Pose2D MatchScan(const LikelihoodField& field, const std::vector<Beam>& beams, const Pose2D& pose,
                 const MatchSettings& settings) {
  const Eigen::Vector3d trust(1 / (settings.trust * settings.trust),
                              1 / (settings.trust * settings.trust),
                              1 / (settings.yaw_trust * settings.yaw_trust));
  Pose2D best = pose;
  for (int i = 0; i < settings.iterations; ++i) {
    Equations equations = OfBeams(field, beams, best, settings);
    const Eigen::Vector3d moved(best.x - pose.x, best.y - pose.y,
                                NormalizeAngle(best.yaw - pose.yaw));
    equations.information += trust.asDiagonal();
    equations.pull -= trust.cwiseProduct(moved);
    const Eigen::Vector3d step = equations.information.ldlt().solve(equations.pull);
    if (!step.allFinite()) break;
    best = {best.x + step(0), best.y + step(1), NormalizeAngle(best.yaw + step(2))};
    if (step.norm() < kSmallStep) break;
  }
  return best;
}

Eigen::Matrix3d MatchInformation(const LikelihoodField& field, const std::vector<Beam>& beams,
                                 const Pose2D& pose, const MatchSettings& settings) {
  return OfBeams(field, beams, pose, settings).information;
}

}  // namespace coppice::robot::localization
