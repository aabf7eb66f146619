// Poses in space that are bound to each other by what was measured between them, and the poses that
// fit all measurements best: nonlinear least squares by Ceres, on SE(3).
//
// A step is what odometry measured between two key frames; it may be noisy, never wrong altogether.
// A closure says that two key frames saw the same place; it may be wrong, and the farther off it is
// the less it counts (Cauchy's kernel), so that one false closure does not bend the map. Which way
// is up may be known of each pose: steps alone let the floor of a long corridor rise unnoticed.
// That, too, counts the less the farther off it is, as on a ramp that odometry knows nothing of.
//
//   PoseGraph graph;
//   graph.poses = {a, b};
//   graph.links = {{0, 1, a.inverse() * b, InformationOf(0.02, 0.01)}};
//   Optimize({0}, {}, graph);
//
// S. Agarwal, K. Mierle: Ceres Solver. R. Kuemmerle, G. Grisetti, H. Strasdat, K. Konolige,
// W. Burgard: g2o: A General Framework for Graph Optimization, ICRA 2011 (the error of a link).
#ifndef COPPICE_ROBOT_APP_SLAM_GRAPH_POSE_GRAPH_H_
#define COPPICE_ROBOT_APP_SLAM_GRAPH_POSE_GRAPH_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace coppice::robot::slam {

/// A place and an orientation; of base_link in a map unless it is said otherwise. Metres.
using Pose3 = Eigen::Isometry3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What measured a link.
enum class LinkKind : std::uint8_t { kStep, kPicture, kCloud };

/// Pose `to` as seen from pose `from` was measured to be `relative`.
struct Link {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Pose3 relative = Pose3::Identity();
  /// Inverse covariance of the position [m] and of the rotation vector [rad], along the axes of
  /// pose `to` as the link says it.
  Matrix6 information = Matrix6::Identity();
  LinkKind kind = LinkKind::kStep;

  bool is_closure() const { return kind != LinkKind::kStep; }
};

/// Which way is up at a pose, of a robot on its floor: by gravity, or because floors are level.
struct Upright {
  Eigen::Vector2d up = {0, 0};  ///< of the unit vector upwards, what lies along its axes x and y
  double information = 0;       ///< inverse variance of both [1/rad^2]; 0: nothing is known
};

/// The indices of the links are those of poses.
struct PoseGraph {
  std::vector<Pose3> poses;
  std::vector<Link> links;
  std::vector<Upright> uprights = {};  ///< of each pose; of those beyond its end nothing is known
};

/// The same standard deviation along all axes [m], and about all axes [rad].
Matrix6 InformationOf(double position, double rotation);

/// What is left between a link and the poses: position and rotation vector, along the axes of pose
/// `to` as the link says it.
Vector6 ErrorOf(const Link& link, const Pose3& from, const Pose3& to);

/// The square of that error, in standard deviations: of a right link, 6 on average.
double SquaredError(const Link& link, const std::vector<Pose3>& poses);

/// How far a pose is tilted from what is known of it [rad], along its axes.
Eigen::Vector2d TiltOf(const Upright& upright, const Pose3& pose);

struct OptimizeSettings {
  int most_iterations = 20;  ///< one takes some 40 ms at 5 000 poses
  /// Squared error from which on a closure, or what is upright, counts for less than half.
  double doubt = 12;
};

/// Moves the poses to where they fit the links best; the poses `fixed` stay. Each pose must be
/// bound to one of them over some way. False, with all poses as they were, if that cannot be
/// calculated.
bool Optimize(const std::vector<std::uint32_t>& fixed, const OptimizeSettings& settings,
              PoseGraph& graph);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_GRAPH_POSE_GRAPH_H_
