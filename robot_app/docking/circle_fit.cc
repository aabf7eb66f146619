#include "robot_app/docking/circle_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace coppice::robot::docking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kIterations = 20;
constexpr double kNone = 1e3;    // a deviation that no circle has [m]
constexpr double kLeast = 1e-6;  // under a root, at the rim [m^2]

// x and y of the middle, radius.
using Circle = Vector3d;

Circle Kasa(const std::vector<Point2D>& echoes) {
  Matrix3d a = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  for (const Point2D& echo : echoes) {
    const Vector3d row(echo.x, echo.y, 1);
    a += row * row.transpose();
    b += row * (echo.x * echo.x + echo.y * echo.y);
  }
  const Vector3d s = (a + 1e-9 * Matrix3d::Identity()).ldlt().solve(b);
  const Vector2d middle = s.head<2>() / 2;
  return {middle.x(), middle.y(), std::sqrt(std::max(1e-4, s.z() + middle.squaredNorm()))};
}

// Sum of the squared deviations; what they say of a better circle is added up.
double Squares(const std::vector<Point2D>& echoes, const Circle& circle, Matrix3d& information,
               Vector3d& slope) {
  information.setZero();
  slope.setZero();
  double squares = 0;
  const Vector2d middle = circle.head<2>();
  for (const Point2D& echo : echoes) {
    const double range = std::hypot(echo.x, echo.y);
    const Vector2d beam = Vector2d(echo.x, echo.y) / range;
    const double along = beam.dot(middle);
    const double root =
        std::sqrt(std::max(kLeast, circle.z() * circle.z() - middle.squaredNorm() + along * along));
    const double residual = range - (along - root);
    const Vector2d by_middle = beam + (middle - along * beam) / root;
    const Vector3d gradient(by_middle.x(), by_middle.y(), -circle.z() / root);
    information += gradient * gradient.transpose();
    slope += gradient * residual;
    squares += residual * residual;
  }
  return squares;
}

}  // namespace

double DeviationFromCircle(const std::vector<Point2D>& echoes) {
  if (echoes.size() < 3) return kNone;
  Circle circle = Kasa(echoes);
  Matrix3d information, next_information;
  Vector3d slope, next_slope;
  double squares = Squares(echoes, circle, information, slope);
  double damping = 1e-3;
  for (int i = 0; i < kIterations; ++i) {
    const Matrix3d damped =
        information + damping * information.diagonal().asDiagonal().toDenseMatrix();
    const Circle next = circle + damped.ldlt().solve(slope);
    if (!next.allFinite()) break;
    const double better = Squares(echoes, next, next_information, next_slope);
    damping *= better < squares ? 0.3 : 10;
    if (better >= squares) continue;
    circle = next;
    squares = better;
    information = next_information;
    slope = next_slope;
  }
  return std::sqrt(squares / static_cast<double>(echoes.size()));
}

}  // namespace coppice::robot::docking
