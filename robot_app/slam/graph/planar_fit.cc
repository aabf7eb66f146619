#include "robot_app/slam/graph/planar_fit.h"

#include <cmath>

namespace coppice::robot::slam {

Pose3 PlanarFit(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  Eigen::Vector3d middle_a = Eigen::Vector3d::Zero(), middle_b = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    middle_a += a[i] / static_cast<double>(a.size());
    middle_b += b[i] / static_cast<double>(a.size());
  }
  double dot = 0, cross = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d from = (b[i] - middle_b).head<2>(), to = (a[i] - middle_a).head<2>();
    dot += from.dot(to);
    cross += from.x() * to.y() - from.y() * to.x();
  }
  Pose3 pose = Pose3::Identity();
  pose.linear() =
      Eigen::AngleAxisd(std::atan2(cross, dot), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = middle_a - pose.linear() * middle_b;
  return pose;
}

}  // namespace coppice::robot::slam
