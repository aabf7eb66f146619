#include "robot_app/perception/legs/leg_features.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace coppice::robot::perception {
namespace {

constexpr double kLargestRadius = 1;  // of a circle; what is larger is straight [m]

using Points = Eigen::Matrix2Xd;

Points PointsOf(const SegmentedScan& scan, const ScanSegment& segment) {
  Points points(2, segment.size());
  for (std::uint32_t i = 0; i < segment.size(); ++i) {
    points.col(i) = scan.points[segment.begin + i].at.cast<double>();
  }
  return points;
}

struct Spread {
  double deviation = 0;    // from the mean
  double from_median = 0;  // in the mean
  double off_line = 0;     // root of mean square from the straight line through them
};

Spread SpreadOf(const Points& points) {
  const auto count = static_cast<double>(points.cols());
  const Points off = points.colwise() - points.rowwise().mean();
  std::vector<double> x(points.row(0).begin(), points.row(0).end());
  std::vector<double> y(points.row(1).begin(), points.row(1).end());
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  const Eigen::Vector2d middle(median(x), median(y));
  const Eigen::Matrix2d scatter = off * off.transpose() / count;
  const double least = scatter.trace() / 2 - std::hypot((scatter(0, 0) - scatter(1, 1)) / 2,
                                                        scatter(0, 1));  // the smaller eigenvalue
  return {std::sqrt(scatter.trace()), (points.colwise() - middle).colwise().norm().sum() / count,
          std::sqrt(std::max(least, 0.0))};
}

struct Circle {
  double radius = 0;
  double off = 0;  // root of mean square from it
};

// Of least squares (Kasa 1976), from the middle of the points so that it is well conditioned.
Circle CircleOf(const Points& points) {
  if (points.cols() < 3) return {};
  const Points off = points.colwise() - points.rowwise().mean();
  Eigen::MatrixX3d lines(off.cols(), 3);
  lines << off.transpose() * 2, Eigen::VectorXd::Ones(off.cols());
  const Eigen::VectorXd squares = off.colwise().squaredNorm().transpose();
  const Eigen::Vector3d found = (lines.transpose() * lines + 1e-9 * Eigen::Matrix3d::Identity())
                                    .ldlt()
                                    .solve(lines.transpose() * squares);
  const double radius = std::sqrt(std::max(found.z() + found.head<2>().squaredNorm(), 0.0));
  if (!(radius < kLargestRadius)) return {kLargestRadius, kLargestRadius};
  const Eigen::Vector2d middle = found.head<2>();
  const Eigen::ArrayXd from = (off.colwise() - middle).colwise().norm().transpose();
  return {radius, std::sqrt((from - radius).square().mean())};
}

struct Boundary {
  double length = 0;
  double unevenness = 0;  // standard deviation of its pieces
  double curvature = 0;   // mean, of three points each [1/m]
  double turning = 0;     // mean angle between two pieces [rad]
};

Boundary BoundaryOf(const Points& points) {
  const Eigen::Index pieces = points.cols() - 1;
  if (pieces < 1) return {};
  const Points along = points.rightCols(pieces) - points.leftCols(pieces);
  const Eigen::ArrayXd lengths = along.colwise().norm().transpose();
  Boundary boundary;
  boundary.length = lengths.sum();
  boundary.unevenness = std::sqrt((lengths - lengths.mean()).square().mean());
  for (Eigen::Index i = 1; i < pieces; ++i) {
    const Eigen::Vector2d a = along.col(i - 1), b = along.col(i);
    const double cross = a.x() * b.y() - a.y() * b.x();
    const double sides = lengths[i - 1] * lengths[i] * (a + b).norm();
    boundary.curvature += 2 * cross / std::max(sides, 1e-9) / static_cast<double>(pieces);
    boundary.turning += std::atan2(cross, a.dot(b)) / static_cast<double>(pieces);
  }
  return boundary;
}

void DescribeSegment(const SegmentedScan& scan, const ScanSegment& segment, float* features) {
  const Points points = PointsOf(scan, segment);
  const Spread spread = SpreadOf(points);
  const Circle circle = CircleOf(points);
  const Boundary boundary = BoundaryOf(points);
  const double values[kSegmentFeatures] = {static_cast<double>(segment.size()),
                                           WidthOf(scan, segment),
                                           spread.deviation,
                                           spread.from_median,
                                           segment.jump_before,
                                           segment.jump_after,
                                           spread.off_line,
                                           circle.off,
                                           circle.radius,
                                           boundary.length,
                                           boundary.unevenness,
                                           boundary.curvature,
                                           boundary.turning,
                                           points.rowwise().mean().norm()};
  std::transform(values, values + kSegmentFeatures, features,
                 [](double value) { return static_cast<float>(value); });
}

}  // namespace

Eigen::Vector2f MiddleOf(const SegmentedScan& scan, const ScanSegment& segment) {
  return PointsOf(scan, segment).rowwise().mean().cast<float>();
}

float WidthOf(const SegmentedScan& scan, const ScanSegment& segment) {
  return (scan.points[segment.begin].at - scan.points[segment.end - 1].at).norm();
}

LegFeatures Describe(const SegmentedScan& scan, const LegCandidate& candidate) {
  LegFeatures features{};
  const ScanSegment& first = scan.segments[candidate.first];
  if (!candidate.second) {
    DescribeSegment(scan, first, features.data());
    return features;
  }
  const ScanSegment& second = scan.segments[*candidate.second];
  const Eigen::Vector2f at[] = {MiddleOf(scan, first), MiddleOf(scan, second)};
  const bool first_is_nearer = at[0].norm() <= at[1].norm();
  DescribeSegment(scan, first_is_nearer ? first : second, features.data());
  DescribeSegment(scan, first_is_nearer ? second : first, features.data() + kSegmentFeatures);
  float* const pair = features.data() + 2 * kSegmentFeatures;
  pair[0] = (at[0] - at[1]).norm();
  pair[1] = std::abs(at[0].norm() - at[1].norm());
  pair[2] = std::sqrt(std::max(pair[0] * pair[0] - pair[1] * pair[1], 0.0F));
  pair[3] = 1;
  return features;
}

}  // namespace coppice::robot::perception
