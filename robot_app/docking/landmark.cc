#include "robot_app/docking/landmark.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot_app/docking/landmark_fit.h"
#include "robot_app/docking/line_segments.h"

namespace coppice::robot::docking {
namespace {

constexpr double kOpeningTolerance = 25 * M_PI / 180;  // of two segments
constexpr double kLengthTolerance = 0.15;              // of one [m]
constexpr double kShortest = 0.3;                      // both together [m]
constexpr double kLargestGap = 0.15;                   // between them [m]
constexpr double kSame = 0.2;                          // two sightings so near are one [m]

double AngleOf(const Point2D& from, const Point2D& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

// Where the corner may be if `right` and `left` are its legs, seen from the robot: by both, by the
// right one and by the left one. Empty if they are not.
std::vector<Pose2D> Corners(const LineSegment& right, const LineSegment& left,
                            const LandmarkShape& shape) {
  const double right_length = Distance(right.from, right.to);
  const double left_length = Distance(left.from, left.to);
  if (std::max(right_length, left_length) > shape.leg + kLengthTolerance ||
      right_length + left_length < kShortest || Distance(right.to, left.from) > kLargestGap) {
    return {};
  }
  const double right_angle = AngleOf(right.to, right.from);
  const double left_angle = AngleOf(left.from, left.to);
  const double opening = NormalizeAngle(left_angle - right_angle);
  if (std::abs(opening - shape.opening) > kOpeningTolerance) return {};
  const Point2D corner = {(right.to.x + left.from.x) / 2, (right.to.y + left.from.y) / 2};
  std::vector<Pose2D> corners;
  for (const double yaw : {right_angle + opening / 2, right_angle + shape.opening / 2,
                           left_angle - shape.opening / 2}) {
    corners.push_back({corner.x, corner.y, NormalizeAngle(yaw)});
  }
  return corners;
}

LandmarkSighting InBase(LandmarkSighting sighting, const Pose2D& mount) {
  sighting.pose = Compose(mount, sighting.pose);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(mount.yaw), -std::sin(mount.yaw), std::sin(mount.yaw),
      std::cos(mount.yaw);
  sighting.covariance = turn * sighting.covariance * turn.transpose();
  return sighting;
}

void AddNew(const LandmarkSighting& sighting, std::vector<LandmarkSighting>& found) {
  for (LandmarkSighting& known : found) {
    if (Distance(known.pose, sighting.pose) > kSame) continue;
    if (sighting.points > known.points) known = sighting;
    return;
  }
  found.push_back(sighting);
}

}  // namespace

std::vector<LandmarkSighting> FindLandmarks(const LaserScan& scan,
                                            const LandmarkSettings& settings) {
  const std::vector<LineSegment> segments = FindSegments(scan, settings.noise, settings.limit);
  std::vector<LandmarkSighting> found;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < std::min(i + 3, segments.size()); ++j) {
      for (const Pose2D& corner : Corners(segments[i], segments[j], settings.shape)) {
        const auto sighting = FitInScan(scan, settings, corner, false);
        if (!sighting) continue;
        AddNew(InBase(*sighting, scan.mount), found);
        break;
      }
    }
  }
  return found;
}

std::optional<LandmarkSighting> FitLandmark(const LaserScan& scan, const LandmarkSettings& settings,
                                            const Pose2D& expected) {
  const auto sighting = FitInScan(scan, settings, RelativeTo(scan.mount, expected), true);
  if (!sighting) return std::nullopt;
  return InBase(*sighting, scan.mount);
}

Pose2D DockedAt(const LandmarkShape& shape, const Pose2D& landmark) {
  return Compose(landmark, Pose2D{-shape.ahead, 0, 0});
}

Pose2D LandmarkOf(const LandmarkShape& shape, const Pose2D& docked) {
  return Compose(docked, Pose2D{shape.ahead, 0, 0});
}

}  // namespace coppice::robot::docking
