#include "robot_app/mapping/pose_graph.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>

namespace coppice::robot::mapping {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

constexpr int kIterations = 30;
constexpr double kDoubt = 10;     // squared error at which a doubtful constraint counts half
constexpr double kEnough = 1e-6;  // share of the cost that a step must save
constexpr double kMostDamped = 1e8;

// What a doubtful squared error costs, and how much the constraint counts then.
double Cost(const PoseConstraint& constraint, double squared) {
  return constraint.doubtful ? kDoubt * std::log1p(squared / kDoubt) : squared;
}
double Weight(const PoseConstraint& constraint, double squared) {
  return constraint.doubtful ? 1 / (1 + squared / kDoubt) : 1;
}

double CostOf(const std::vector<PoseConstraint>& constraints, const std::vector<Pose2D>& poses) {
  double sum = 0;
  for (const PoseConstraint& constraint : constraints) {
    const Eigen::Vector3d error = ErrorOf(constraint, poses);
    sum += Cost(constraint, error.dot(constraint.information * error));
  }
  return sum;
}

// The derivatives of ErrorOf by both poses.
struct Slopes {
  Eigen::Matrix3d from = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d to = Eigen::Matrix3d::Zero();
};

Slopes SlopesOf(const PoseConstraint& constraint, const std::vector<Pose2D>& poses) {
  const Pose2D& from = poses[constraint.from];
  const Pose2D& to = poses[constraint.to];
  const double angle = from.yaw + constraint.relative.yaw;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  Slopes slopes;
  slopes.to << c, s, 0, -s, c, 0, 0, 0, 1;
  slopes.from << -c, -s, -s * x + c * y, s, -c, -c * x - s * y, 0, 0, -1;
  return slopes;
}

struct Equations {
  Matrix left;
  Vector right;
};

// Of all poses but the first one, which stays.
class EquationWriter {
 public:
  explicit EquationWriter(std::size_t poses) : right_(Vector::Zero(3 * (poses - 1))) {}

  void Add(const PoseConstraint& constraint, const std::vector<Pose2D>& poses) {
    const Eigen::Vector3d error = ErrorOf(constraint, poses);
    const double weight = Weight(constraint, error.dot(constraint.information * error));
    const Eigen::Matrix3d information = weight * constraint.information;
    const Slopes slopes = SlopesOf(constraint, poses);
    AddBlock(constraint.from, constraint.from, slopes.from.transpose() * information * slopes.from);
    AddBlock(constraint.from, constraint.to, slopes.from.transpose() * information * slopes.to);
    AddBlock(constraint.to, constraint.from, slopes.to.transpose() * information * slopes.from);
    AddBlock(constraint.to, constraint.to, slopes.to.transpose() * information * slopes.to);
    AddRight(constraint.from, slopes.from.transpose() * information * error);
    AddRight(constraint.to, slopes.to.transpose() * information * error);
  }

  Equations Write() const {
    Equations equations{Matrix(right_.size(), right_.size()), right_};
    equations.left.setFromTriplets(entries_.begin(), entries_.end());
    return equations;
  }

 private:
  void AddBlock(std::size_t row, std::size_t column, const Eigen::Matrix3d& block) {
    if (row == 0 || column == 0) return;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        entries_.emplace_back(static_cast<int>(3 * (row - 1)) + i,
                              static_cast<int>(3 * (column - 1)) + j, block(i, j));
      }
    }
  }
  void AddRight(std::size_t row, const Eigen::Vector3d& value) {
    if (row != 0) right_.segment<3>(3 * (static_cast<Eigen::Index>(row) - 1)) -= value;
  }

  std::vector<Eigen::Triplet<double>> entries_;
  Vector right_;
};

std::vector<Pose2D> Moved(const std::vector<Pose2D>& poses, const Vector& step) {
  std::vector<Pose2D> moved = poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto part = step.segment<3>(3 * (static_cast<Eigen::Index>(i) - 1));
    moved[i] = {poses[i].x + part(0), poses[i].y + part(1), NormalizeAngle(poses[i].yaw + part(2))};
  }
  return moved;
}

}  // namespace

Eigen::Matrix3d AlongAxesOf(const Pose2D& pose, const Eigen::Matrix3d& information) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  axes.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(pose.yaw).toRotationMatrix();
  return axes.transpose() * information * axes;
}

Eigen::Vector3d ErrorOf(const PoseConstraint& constraint, const std::vector<Pose2D>& poses) {
  const Pose2D seen = RelativeTo(poses[constraint.from], poses[constraint.to]);
  const Pose2D error = RelativeTo(constraint.relative, seen);
  return {error.x, error.y, NormalizeAngle(error.yaw)};
}

void OptimizePoses(const std::vector<PoseConstraint>& constraints, std::vector<Pose2D>& poses) {
  if (poses.size() < 2) return;
  double cost = CostOf(constraints, poses);
  double damping = 1e-6;
  for (int i = 0; i < kIterations && damping < kMostDamped; ++i) {
    EquationWriter writer(poses.size());
    for (const PoseConstraint& constraint : constraints) writer.Add(constraint, poses);
    Equations equations = writer.Write();
    for (Eigen::Index j = 0; j < equations.left.rows(); ++j) {
      equations.left.coeffRef(j, j) *= 1 + damping;
    }
    const Eigen::SimplicialLDLT<Matrix> solver(equations.left);
    if (solver.info() != Eigen::Success) return;
    const Vector step = solver.solve(equations.right);
    if (!step.allFinite()) return;
    std::vector<Pose2D> moved = Moved(poses, step);
    const double moved_cost = CostOf(constraints, moved);
    if (!(moved_cost < cost)) {
      damping *= 100;
      continue;
    }
    const bool enough = cost - moved_cost < kEnough * cost;
    poses = std::move(moved);
    cost = moved_cost;
    damping /= 10;
    if (enough) return;
  }
}

}  // namespace coppice::robot::mapping
