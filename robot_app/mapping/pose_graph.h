// Poses that are bound to each other by what was measured between them, and the poses that fit all
// measurements best.
//
// G. Grisetti, R. Kuemmerle, C. Stachniss, W. Burgard: A Tutorial on Graph-Based SLAM, IEEE
// Intelligent Transportation Systems Magazine 2 (2010): Gauss-Newton on the sparse normal
// equations, here damped (Levenberg, Marquardt).
#ifndef COPPICE_ROBOT_APP_MAPPING_POSE_GRAPH_H_
#define COPPICE_ROBOT_APP_MAPPING_POSE_GRAPH_H_

#include <Eigen/Core>
#include <vector>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::mapping {

/// Pose `to` as seen from pose `from` was measured to be `relative`.
struct PoseConstraint {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2D relative;
  /// Inverse covariance of x, y [m] and yaw [rad] of `relative`, along the axes of pose `to`.
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  /// It may be wrong altogether: the farther off it is, the less it counts (Cauchy).
  bool doubtful = false;
};

/// Information given along the axes of the map, along the axes of `pose`.
Eigen::Matrix3d AlongAxesOf(const Pose2D& pose, const Eigen::Matrix3d& information);

/// What is left between a constraint and the poses: x, y, yaw along the axes of pose `to`.
Eigen::Vector3d ErrorOf(const PoseConstraint& constraint, const std::vector<Pose2D>& poses);

/// Moves the poses to where they fit the constraints best; the first one stays. Indices must be
/// those of poses, and each pose must be bound to the first one over some way. Poses that cannot be
/// made better stay as they are.
void OptimizePoses(const std::vector<PoseConstraint>& constraints, std::vector<Pose2D>& poses);

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_POSE_GRAPH_H_
