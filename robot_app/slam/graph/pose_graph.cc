#include "robot_app/slam/graph/pose_graph.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

namespace coppice::robot::slam {
namespace {

using Parameters = std::array<double, 7>;  // position, quaternion x, y, z, w

Parameters ToParameters(const Pose3& pose) {
  const Eigen::Quaterniond rotation(pose.linear());
  return {pose.translation().x(),
          pose.translation().y(),
          pose.translation().z(),
          rotation.x(),
          rotation.y(),
          rotation.z(),
          rotation.w()};
}

Pose3 ToPose(const Parameters& parameters) {
  Pose3 pose = Pose3::Identity();
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(parameters.data());
  const Eigen::Map<const Eigen::Quaterniond> rotation(parameters.data() + 3);
  pose.linear() = rotation.normalized().toRotationMatrix();
  return pose;
}

// Position and twice the vector part of the quaternion, which is the rotation vector of a small
// rotation, of `to` as seen from `from`, less what was measured.
template <typename T>
Eigen::Matrix<T, 6, 1> Residual(const Pose3& relative, const T* from, const T* to) {
  using Vector = Eigen::Matrix<T, 3, 1>;
  using Quaternion = Eigen::Quaternion<T>;
  const Eigen::Map<const Vector> from_position(from), to_position(to);
  const Eigen::Map<const Quaternion> from_rotation(from + 3), to_rotation(to + 3);
  const Quaternion measured = Eigen::Quaterniond(relative.linear()).cast<T>();
  const Vector seen = from_rotation.conjugate() * (to_position - from_position);
  const Vector position = measured.conjugate() * (seen - Vector(relative.translation().cast<T>()));
  const Quaternion rotation = measured.conjugate() * from_rotation.conjugate() * to_rotation;
  Eigen::Matrix<T, 6, 1> residual;
  residual << position, T(rotation.w() < T(0) ? -2.0 : 2.0) * rotation.vec();
  return residual;
}

struct LinkCost {
  Pose3 relative;
  Matrix6 root;  // of the information: root' root

  template <typename T>
  bool operator()(const T* from, const T* to, T* residual) const {
    Eigen::Map<Eigen::Matrix<T, 6, 1>> out(residual);
    out = root.cast<T>() * Residual(relative, from, to);
    return true;
  }
};

// Of the unit vector upwards, along the axes of the pose, less what is known of it.
template <typename T>
Eigen::Matrix<T, 2, 1> Tilt(const Eigen::Vector2d& up, const T* pose) {
  const Eigen::Map<const Eigen::Quaternion<T>> rotation(pose + 3);
  const Eigen::Matrix<T, 3, 1> seen =
      rotation.conjugate() * Eigen::Matrix<T, 3, 1>(T(0), T(0), T(1));
  return seen.template head<2>() - up.cast<T>();
}

struct UprightCost {
  Upright upright;

  template <typename T>
  bool operator()(const T* pose, T* residual) const {
    Eigen::Map<Eigen::Matrix<T, 2, 1>> out(residual);
    out = T(std::sqrt(upright.information)) * Tilt(upright.up, pose);
    return true;
  }
};

ceres::CostFunction* CostOf(const Link& link) {
  const Matrix6 root = Eigen::LLT<Matrix6>(link.information).matrixU();
  return new ceres::AutoDiffCostFunction<LinkCost, 6, 7, 7>(new LinkCost{link.relative, root});
}

// What Ceres is asked about; it refers to `parameters`.
void Describe(const PoseGraph& graph, const std::vector<std::uint32_t>& fixed, double doubt,
              std::vector<Parameters>& parameters, ceres::Problem& problem) {
  auto* const pose_manifold =
      new ceres::ProductManifold<ceres::EuclideanManifold<3>, ceres::EigenQuaternionManifold>();
  for (Parameters& pose : parameters) problem.AddParameterBlock(pose.data(), 7, pose_manifold);
  for (const std::uint32_t i : fixed) problem.SetParameterBlockConstant(parameters[i].data());
  for (const Link& link : graph.links) {
    ceres::LossFunction* const loss =
        link.is_closure() ? new ceres::CauchyLoss(std::sqrt(doubt)) : nullptr;
    problem.AddResidualBlock(CostOf(link), loss, parameters[link.from].data(),
                             parameters[link.to].data());
  }
  for (std::size_t i = 0; i < graph.uprights.size(); ++i) {
    if (graph.uprights[i].information <= 0) continue;
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<UprightCost, 2, 7>(new UprightCost{graph.uprights[i]}),
        new ceres::CauchyLoss(std::sqrt(doubt)), parameters[i].data());
  }
}

}  // namespace

Matrix6 InformationOf(double position, double rotation) {
  Vector6 information;
  information.head<3>().setConstant(1 / (position * position));
  information.tail<3>().setConstant(1 / (rotation * rotation));
  return information.asDiagonal();
}

Vector6 ErrorOf(const Link& link, const Pose3& from, const Pose3& to) {
  return Residual(link.relative, ToParameters(from).data(), ToParameters(to).data());
}

double SquaredError(const Link& link, const std::vector<Pose3>& poses) {
  const Vector6 error = ErrorOf(link, poses[link.from], poses[link.to]);
  return error.dot(link.information * error);
}

Eigen::Vector2d TiltOf(const Upright& upright, const Pose3& pose) {
  return Tilt(upright.up, ToParameters(pose).data());
}

bool Optimize(const std::vector<std::uint32_t>& fixed, const OptimizeSettings& settings,
              PoseGraph& graph) {
  if (graph.poses.size() < 2) return true;
  std::vector<Parameters> parameters;
  parameters.reserve(graph.poses.size());
  for (const Pose3& pose : graph.poses) parameters.push_back(ToParameters(pose));
  ceres::Problem problem;
  Describe(graph, fixed, settings.doubt, parameters, problem);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = settings.most_iterations;
  options.function_tolerance = 1e-4;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) return false;
  for (std::size_t i = 0; i < parameters.size(); ++i) graph.poses[i] = ToPose(parameters[i]);
  return true;
}

}  // namespace coppice::robot::slam
