// Transforms of messages for Eigen.
#ifndef COPPICE_ROBOT_APP_COMMON_TRANSFORMS_EIGEN_TRANSFORM_H_
#define COPPICE_ROBOT_APP_COMMON_TRANSFORMS_EIGEN_TRANSFORM_H_

#include <geometry_msgs/Transform.h>

#include <Eigen/Geometry>

namespace coppice::robot {

/// The rotation need not be of length one.
inline Eigen::Isometry3d ToEigen(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  const auto& at = transform.translation;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation() = Eigen::Vector3d(at.x, at.y, at.z);
  return pose;
}

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_TRANSFORMS_EIGEN_TRANSFORM_H_
