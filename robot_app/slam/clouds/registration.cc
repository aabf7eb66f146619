#include "robot_app/slam/clouds/registration.h"

#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "robot_app/slam/graph/floor_pose.h"

namespace coppice::robot::slam {
namespace {

using Point = pcl::PointXYZ;
using Points = pcl::PointCloud<Point>;

constexpr float kFloor = 0.15F;   // m
constexpr float kLevel = 0.6F;    // of a normal upwards: floor, ceiling, desks
constexpr int kNeighbours = 8;    // for a normal
constexpr float kLeast = 0.6F;    // m: nearer is the robot itself
constexpr std::size_t kFew = 60;  // points: nothing to compare

// Pairs of points may be so far apart, and so many steps are done, with so many points: those of a
// hall are no better than those of an office.
struct Pass {
  double pairs;
  int steps;
  std::size_t points;
};
constexpr Pass kPasses[] = {{1.5, 12, 200}, {0.6, 10, 400}, {0.25, 8, 800}};
constexpr double kStill = 1e-4;   // m and rad: a step is the last one
constexpr float kAcross = 0.75F;  // of a normal along the weakest direction: it holds that
constexpr float kAlike = 0.8F;    // cosine between the normals of a pair

// A cloud in which the nearest points are found.
class Target {
 public:
  explicit Target(const ThinCloud& cloud) : cloud_(cloud), points_(new Points) {
    points_->reserve(cloud.points.size());
    for (const Eigen::Vector3f& point : cloud.points) {
      points_->emplace_back(point.x(), point.y(), point.z());
    }
    tree_.setInputCloud(points_);
  }

  // The point of the surface that is nearest and looks the same way; nothing within `most`.
  std::optional<std::size_t> Find(const Eigen::Vector3f& point, const Eigen::Vector3f& normal,
                                  double most) {
    if (tree_.nearestKSearch(Point(point.x(), point.y(), point.z()), 1, index_, square_) == 0) {
      return std::nullopt;
    }
    const auto nearest = static_cast<std::size_t>(index_[0]);
    if (square_[0] > most * most) return std::nullopt;
    if (std::abs(cloud_.normals[nearest].dot(normal)) < kAlike) return std::nullopt;
    return nearest;
  }
  const ThinCloud& cloud() const { return cloud_; }

 private:
  const ThinCloud& cloud_;
  Points::Ptr points_;
  pcl::KdTreeFLANN<Point> tree_;
  std::vector<int> index_ = std::vector<int>(1);
  std::vector<float> square_ = std::vector<float>(1);
};

// One step of ICP: the shift and turn that lay the points best upon the surfaces beside them (Chen
// and Medioni), what is farther off counting for less. Walls do not hold what slides along them.
std::optional<Pose3> StepOf(Target& old_cloud, const ThinCloud& new_cloud, const Pose3& pose,
                            const Pass& pass) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d error = Eigen::Vector3d::Zero();
  const Eigen::Isometry3f moved = pose.cast<float>();
  const std::size_t every = (new_cloud.points.size() + pass.points - 1) / pass.points;
  for (std::size_t i = 0; i < new_cloud.points.size(); i += every) {
    const Eigen::Vector3f point = moved * new_cloud.points[i];
    const auto pair = old_cloud.Find(point, moved.linear() * new_cloud.normals[i], pass.pairs);
    if (!pair) continue;
    const Eigen::Vector3f& normal = old_cloud.cloud().normals[*pair];
    const double off = normal.dot(point - old_cloud.cloud().points[*pair]);
    const double weight = 1 / (1 + off * off / (pass.pairs * pass.pairs / 16));
    const Eigen::Vector3d row(normal.x(), normal.y(),
                              normal.y() * point.x() - normal.x() * point.y());
    information += weight * row * row.transpose();
    error += weight * off * row;
  }
  // What nothing holds stays where it is.
  information.diagonal().array() += 1e-3 * information.trace() / 3 + 1e-9;
  const Eigen::Vector3d step = -information.ldlt().solve(error);
  if (!step.allFinite()) return std::nullopt;
  return ToPose3({step.x(), step.y(), step.z()}) * pose;
}

struct Agreement {
  double overlap = 0;
  double squares = 0;  // of the distances of what agrees, along the normals
  std::size_t agree = 0;
  Eigen::Matrix2d normals = Eigen::Matrix2d::Zero();  // of what agrees, in the new cloud's frame
  std::vector<bool> agrees;
};

// How much of `cloud`, moved by `motion`, lies upon the target.
Agreement AgreeWith(Target& target, const ThinCloud& cloud, const Pose3& motion, double near) {
  Agreement agreement;
  const Eigen::Isometry3f moved = motion.cast<float>();
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f point = moved * cloud.points[i];
    const auto nearest = target.Find(point, moved.linear() * cloud.normals[i], near);
    agreement.agrees.push_back(nearest.has_value());
    if (!nearest) continue;
    ++agreement.agree;
    const float off =
        (moved.linear() * cloud.normals[i]).dot(point - target.cloud().points[*nearest]);
    agreement.squares += off * off;
    const Eigen::Vector2d normal = cloud.normals[i].head<2>().cast<double>();
    agreement.normals += normal * normal.transpose();
  }
  agreement.overlap = static_cast<double>(agreement.agree) /
                      std::max<double>(static_cast<double>(cloud.points.size()), 1);
  return agreement;
}

// What holds a direction: surfaces that look that way.
struct Hold {
  int agree = 0;
  double share = 0;  // of them, that agree
};
Hold HoldOf(const ThinCloud& cloud, const std::vector<bool>& agrees, const Eigen::Vector2f& way) {
  int all = 0;
  Hold hold;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (std::abs(cloud.normals[i].head<2>().dot(way)) < kAcross) continue;
    ++all;
    hold.agree += agrees[i] ? 1 : 0;
  }
  hold.share = static_cast<double>(hold.agree) / std::max(all, 1);
  return hold;
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
  Target old_target(old_cloud), new_target(new_cloud);
  Registration registration;
  registration.relative = guess;
  for (const Pass& pass : kPasses) {
    for (int i = 0; i < pass.steps; ++i) {
      const auto moved = StepOf(old_target, new_cloud, registration.relative, pass);
      if (!moved) return std::nullopt;
      const Pose3 step = registration.relative.inverse() * *moved;
      registration.relative = *moved;
      if (step.translation().norm() < kStill && Eigen::AngleAxisd(step.linear()).angle() < kStill) {
        break;
      }
    }
  }
  const Pose3 back = registration.relative.inverse();
  const Agreement of_new = AgreeWith(old_target, new_cloud, registration.relative, settings.near);
  const Agreement of_old = AgreeWith(new_target, old_cloud, back, settings.near);
  registration.overlap = std::min(of_new.overlap, of_old.overlap);
  const auto agree = static_cast<double>(of_new.agree + of_old.agree);
  registration.residual = std::sqrt((of_new.squares + of_old.squares) / std::max(agree, 1.0));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(of_new.normals);
  const Eigen::Vector2f weak = solver.eigenvectors().col(0).cast<float>();
  const Eigen::Vector3f there =
      registration.relative.linear().cast<float>() * Eigen::Vector3f(weak.x(), weak.y(), 0);
  const Hold in_new = HoldOf(new_cloud, of_new.agrees, weak);
  const Hold in_old = HoldOf(old_cloud, of_old.agrees, there.head<2>());
  registration.hold = std::min(in_new.agree, in_old.agree);
  registration.hold_share = std::min(in_new.share, in_old.share);
  return registration;
}

bool IsSure(const Registration& registration, const RegistrationSettings& settings) {
  return registration.overlap >= settings.least_overlap &&
         registration.residual <= settings.most_residual &&
         registration.hold >= settings.least_hold &&
         registration.hold_share >= settings.least_hold_share &&
         registration.relative.translation().norm() <= settings.most_way;
}

}  // namespace coppice::robot::slam
