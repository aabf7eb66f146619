#include "robot_app/common/laser_scan.h"

#include <cmath>

namespace coppice::robot {
namespace {

// Beams without a direction tell nothing.
std::size_t TellingBeams(const LaserScan& scan) {
  if (!std::isfinite(scan.angle_min) || !std::isfinite(scan.angle_increment)) return 0;
  std::size_t telling = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (scan.Hit(i) || scan.MetNothing(i)) ++telling;
  }
  return telling;
}

}  // namespace

bool IsUsable(const LaserScan& scan) {
  const std::size_t telling = TellingBeams(scan);
  return telling > 0 && static_cast<double>(telling) >=
                            kLeastTellingShare * static_cast<double>(scan.ranges.size());
}

std::string WhatTells(const LaserScan& scan) {
  return std::to_string(TellingBeams(scan)) + " of " + std::to_string(scan.ranges.size()) +
         " beams tell something";
}

std::vector<Point2D> PointsInBase(const LaserScan& scan, double limit) {
  std::vector<Point2D> points;
  points.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (!scan.Hit(i) || scan.ranges[i] > limit) continue;
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    points.push_back(Compose(
        scan.mount, Point2D{scan.ranges[i] * std::cos(angle), scan.ranges[i] * std::sin(angle)}));
  }
  return points;
}

}  // namespace coppice::robot
