#include "robot_app/slam/clouds/registration.h"

#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/transformation_estimation_2D.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace coppice::robot::slam {
namespace {

using Point = pcl::PointXYZ;
using Points = pcl::PointCloud<Point>;

constexpr float kFloor = 0.15F;   // m
constexpr float kLevel = 0.6F;    // of a normal upwards: floor, ceiling, desks
constexpr int kNeighbours = 8;    // for a normal
constexpr float kLeast = 0.6F;    // m: nearer is the robot itself
constexpr std::size_t kFew = 60;  // points: nothing to compare

// Pairs of points may be so far apart, and so many steps are done.
struct Pass {
  double pairs;
  int steps;
};
constexpr Pass kPasses[] = {{1.5, 15}, {0.6, 15}, {0.25, 20}};

Points::Ptr ToPcl(const CloudPoints& points) {
  Points::Ptr cloud(new Points);
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& point : points) cloud->emplace_back(point.x(), point.y(), point.z());
  return cloud;
}

Eigen::Matrix4f Matrix(const Pose3& pose) { return pose.matrix().cast<float>(); }

struct Agreement {
  double overlap = 0;
  double squares = 0;  // of the distances of what agrees, along the normals
  std::size_t agree = 0;
  Eigen::Matrix2d normals = Eigen::Matrix2d::Zero();  // of what agrees
};

// How much of `cloud`, moved by `motion`, lies upon the points of `tree`.
Agreement AgreeWith(const pcl::KdTreeFLANN<Point>& tree, const ThinCloud& cloud,
                    const Pose3& motion, double near) {
  Agreement agreement;
  std::vector<int> index(1);
  std::vector<float> square(1);
  const Eigen::Isometry3f moved = motion.cast<float>();
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f point = moved * cloud.points[i];
    if (tree.nearestKSearch(Point(point.x(), point.y(), point.z()), 1, index, square) == 0)
      continue;
    if (square[0] > near * near) continue;
    ++agreement.agree;
    const Eigen::Vector3f nearest =
        (*tree.getInputCloud())[static_cast<std::size_t>(index[0])].getVector3fMap();
    const float off = (moved.linear() * cloud.normals[i]).dot(point - nearest);
    agreement.squares += off * off;
    const Eigen::Vector2d normal = cloud.normals[i].head<2>().cast<double>();
    agreement.normals += normal * normal.transpose();
  }
  agreement.overlap = static_cast<double>(agreement.agree) /
                      std::max<double>(static_cast<double>(cloud.points.size()), 1);
  return agreement;
}

// The share of the weaker direction in what the normals hold.
double HoldOf(const Eigen::Matrix2d& normals) {
  const double trace = normals.trace();
  if (trace <= 0) return 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(normals);
  return solver.eigenvalues()(0) / trace;
}

}  // namespace

ThinCloud ThinOut(const CloudPoints& points, double leaf, double range) {
  Points::Ptr all(new Points), thin(new Points);
  for (const Eigen::Vector3f& point : points) {
    const float distance = point.head<2>().norm();
    if (distance < kLeast || distance > range || point.z() < kFloor) continue;
    all->emplace_back(point.x(), point.y(), point.z());
  }
  ThinCloud cloud;
  if (all->size() < kFew) return cloud;
  pcl::VoxelGrid<Point> grid;
  grid.setInputCloud(all);
  const auto size = static_cast<float>(leaf);
  grid.setLeafSize(size, size, size);
  grid.filter(*thin);
  pcl::NormalEstimation<Point, pcl::Normal> estimation;
  pcl::PointCloud<pcl::Normal> normals;
  estimation.setInputCloud(thin);
  estimation.setKSearch(kNeighbours);
  estimation.compute(normals);
  for (std::size_t i = 0; i < thin->size(); ++i) {
    const Eigen::Vector3f normal = normals[i].getNormalVector3fMap();
    if (!normal.allFinite() || std::abs(normal.z()) > kLevel) continue;
    cloud.points.push_back((*thin)[i].getVector3fMap());
    cloud.normals.push_back(normal);
  }
  return cloud;
}

std::optional<Registration> Register(const ThinCloud& old_cloud, const ThinCloud& new_cloud,
                                     const Pose3& guess, const RegistrationSettings& settings) {
  if (old_cloud.points.size() < kFew || new_cloud.points.size() < kFew) return std::nullopt;
  const Points::Ptr target = ToPcl(old_cloud.points), source = ToPcl(new_cloud.points);
  pcl::IterativeClosestPoint<Point, Point> icp;
  icp.setInputTarget(target);
  icp.setInputSource(source);
  icp.setTransformationEstimation(pcl::registration::TransformationEstimation2D<Point, Point>::Ptr(
      new pcl::registration::TransformationEstimation2D<Point, Point>));
  icp.setTransformationEpsilon(1e-6);
  Eigen::Matrix4f found = Matrix(guess);
  for (const Pass& pass : kPasses) {
    Points moved;
    icp.setMaxCorrespondenceDistance(pass.pairs);
    icp.setMaximumIterations(pass.steps);
    icp.align(moved, found);
    if (!icp.getFinalTransformation().allFinite()) return std::nullopt;
    found = icp.getFinalTransformation();
  }
  Registration registration;
  registration.relative.translation() = found.topRightCorner<3, 1>().cast<double>();
  registration.relative.linear() =
      Eigen::AngleAxisd(std::atan2(found(1, 0), found(0, 0)), Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  pcl::KdTreeFLANN<Point> new_tree;
  new_tree.setInputCloud(source);
  pcl::KdTreeFLANN<Point> old_tree;
  old_tree.setInputCloud(target);
  const Agreement of_new = AgreeWith(old_tree, new_cloud, registration.relative, settings.near);
  const Agreement of_old =
      AgreeWith(new_tree, old_cloud, registration.relative.inverse(), settings.near);
  registration.overlap = std::min(of_new.overlap, of_old.overlap);
  const auto agree = static_cast<double>(of_new.agree + of_old.agree);
  registration.residual = std::sqrt((of_new.squares + of_old.squares) / std::max(agree, 1.0));
  registration.hold = HoldOf(of_new.normals);
  return registration;
}

bool IsSure(const Registration& registration, const RegistrationSettings& settings) {
  return registration.overlap >= settings.least_overlap &&
         registration.residual <= settings.most_residual &&
         registration.hold >= settings.least_hold &&
         registration.relative.translation().norm() <= settings.most_way;
}

}  // namespace coppice::robot::slam
