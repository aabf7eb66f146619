#include "robot_app/slam/graph/coarse_graph.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace coppice::robot::slam {
namespace {

// Sets that grow together.
class Sets {
 public:
  explicit Sets(std::size_t size) : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }
  std::uint32_t Find(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  // The lowest member stands for its set.
  void Unite(std::uint32_t a, std::uint32_t b) {
    a = Find(a);
    b = Find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

using Square = std::array<long, 3>;

Square SquareOf(const Pose3& pose, double edge) {
  const Eigen::Vector3d& at = pose.translation();
  return {std::lround(at.x() / edge), std::lround(at.y() / edge), std::lround(at.z() / edge)};
}

struct Groups {
  std::vector<std::uint32_t> of;      // of each pose
  std::vector<std::uint32_t> firsts;  // the first pose of each
};

Groups GroupsOf(const PoseGraph& graph, const std::vector<bool>& binds, double edge) {
  std::vector<Square> squares(graph.poses.size());
  for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = SquareOf(graph.poses[i], edge);
  Sets sets(graph.poses.size());
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    const Link& link = graph.links[i];
    if (binds[i] && squares[link.from] == squares[link.to]) sets.Unite(link.from, link.to);
  }
  Groups groups{std::vector<std::uint32_t>(graph.poses.size()), {}};
  for (std::uint32_t i = 0; i < graph.poses.size(); ++i) {
    const std::uint32_t first = sets.Find(i);
    if (first == i) {
      groups.of[i] = static_cast<std::uint32_t>(groups.firsts.size());
      groups.firsts.push_back(i);
    } else {
      groups.of[i] = groups.of[first];
    }
  }
  return groups;
}

Eigen::Matrix3d Cross(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

// Takes a small motion along the axes of one frame to those of another, which is `pose` as seen
// from that.
Matrix6 Adjoint(const Pose3& pose) {
  Matrix6 matrix = Matrix6::Zero();
  matrix.topLeftCorner<3, 3>() = pose.linear();
  matrix.bottomRightCorner<3, 3>() = pose.linear();
  matrix.topRightCorner<3, 3>() = Cross(pose.translation()) * pose.linear();
  return matrix;
}

Pose3 SmallMotion(const Vector6& motion) {
  Pose3 pose = Pose3::Identity();
  pose.translation() = motion.head<3>();
  const Eigen::Vector3d turn = motion.tail<3>();
  const double angle = turn.norm();
  if (angle > 0) pose.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  return pose;
}

// What was measured the other way round. Errors: E' = R E^-1 R^-1 with R the relative pose.
Link Reversed(const Link& link) {
  const Matrix6 turned = Adjoint(link.relative.inverse());
  return {link.to, link.from, link.relative.inverse(),
          turned.transpose() * link.information * turned, link.kind};
}

// All that was measured between two groups.
struct Sum {
  Matrix6 information = Matrix6::Zero();
  Vector6 error = Vector6::Zero();  // weighed by the information
};

// A group tilts as one: by how much its key frames are tilted on average, along the map's axes.
std::vector<Upright> UprightsOf(const PoseGraph& graph, const CoarseGraph& coarse, double doubt) {
  std::vector<Eigen::Vector3d> tilts(coarse.graph.poses.size(), Eigen::Vector3d::Zero());
  std::vector<Upright> uprights(coarse.graph.poses.size());
  for (std::size_t i = 0; i < graph.uprights.size(); ++i) {
    const Eigen::Vector2d tilt = TiltOf(graph.uprights[i], graph.poses[i]);
    const double known = graph.uprights[i].information;
    const double weight = known / (1 + known * tilt.squaredNorm() / doubt);
    const std::uint32_t group = coarse.group_of[i];
    uprights[group].information += weight;
    tilts[group] += weight * (graph.poses[i].linear().leftCols<2>() * tilt);
  }
  for (std::size_t group = 0; group < uprights.size(); ++group) {
    if (uprights[group].information <= 0) continue;
    const Pose3& pose = coarse.graph.poses[group];
    const Eigen::Vector3d tilt =
        pose.linear().transpose() * tilts[group] / uprights[group].information;
    uprights[group].up = TiltOf({}, pose) - tilt.head<2>();
  }
  return uprights;
}

}  // namespace

Link BetweenGroups(const CoarseGraph& coarse, const std::vector<Pose3>& poses, const Link& link) {
  const std::uint32_t a = coarse.group_of[link.from], b = coarse.group_of[link.to];
  const Pose3 from = coarse.graph.poses[a].inverse() * poses[link.from];
  const Pose3 back = poses[link.to].inverse() * coarse.graph.poses[b];
  const Matrix6 turned = Adjoint(back);
  return {a, b, from * link.relative * back, turned.transpose() * link.information * turned,
          link.kind};
}

CoarseGraph MakeCoarse(const PoseGraph& graph, const CoarseSettings& settings) {
  std::vector<bool> binds(graph.links.size());
  std::vector<double> errors(graph.links.size());
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    const Link& link = graph.links[i];
    errors[i] = link.is_closure() ? SquaredError(link, graph.poses) : 0;
    binds[i] = errors[i] <= settings.most_error;
  }
  double edge = settings.square;
  Groups groups = GroupsOf(graph, binds, edge);
  for (; groups.firsts.size() > settings.most_groups && edge < 1e6; edge *= 2) {
    groups = GroupsOf(graph, binds, 2 * edge);
  }
  CoarseGraph coarse;
  coarse.group_of = std::move(groups.of);
  for (const std::uint32_t first : groups.firsts) coarse.graph.poses.push_back(graph.poses[first]);
  coarse.graph.uprights = UprightsOf(graph, coarse, settings.optimize.doubt);
  std::map<std::pair<std::uint32_t, std::uint32_t>, Sum> sums;
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    Link link = graph.links[i];
    if (coarse.group_of[link.from] == coarse.group_of[link.to]) continue;
    if (coarse.group_of[link.from] > coarse.group_of[link.to]) link = Reversed(link);
    // As Cauchy's kernel weighs it.
    link.information /= 1 + errors[i] / settings.optimize.doubt;
    const Link between = BetweenGroups(coarse, graph.poses, link);
    Sum& sum = sums[{between.from, between.to}];
    sum.information += between.information;
    sum.error += between.information *
                 ErrorOf(between, coarse.graph.poses[between.from], coarse.graph.poses[between.to]);
  }
  for (const auto& [pair, sum] : sums) {
    const Pose3 now = coarse.graph.poses[pair.first].inverse() * coarse.graph.poses[pair.second];
    const Vector6 off = Eigen::LDLT<Matrix6>(sum.information).solve(sum.error);
    coarse.graph.links.push_back(
        {pair.first, pair.second, now * SmallMotion(-off), sum.information, LinkKind::kStep});
  }
  return coarse;
}

void MoveWithGroups(const CoarseGraph& coarse, const std::vector<Pose3>& before,
                    std::vector<Pose3>& poses) {
  std::vector<Pose3> motions;
  motions.reserve(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    motions.push_back(coarse.graph.poses[i] * before[i].inverse());
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i] = motions[coarse.group_of[i]] * poses[i];
  }
}

}  // namespace coppice::robot::slam
