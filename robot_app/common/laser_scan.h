// One sweep of the planar laser scanner, as navigation needs it.
#ifndef COPPICE_ROBOT_APP_COMMON_LASER_SCAN_H_
#define COPPICE_ROBOT_APP_COMMON_LASER_SCAN_H_

#include <cstddef>
#include <string>
#include <vector>

#include "robot_app/common/pose2d.h"

namespace coppice::robot {

struct LaserScan {
  double stamp = 0;            ///< time of the measurement [s]
  Pose2D mount{0.25, 0, 0};    ///< the scanner in base_link
  double angle_min = -2.3562;  ///< of the first beam, in the scanner's frame [rad]
  double angle_increment = 0.0087266;
  double range_min = 0.05;  ///< nearer readings are no echo [m]
  double range_max = 25.0;  ///< readings from here on, or infinite, saw nothing [m]
  std::vector<float> ranges;

  bool Hit(std::size_t beam) const { return ranges[beam] >= range_min && ranges[beam] < range_max; }
  bool MetNothing(std::size_t beam) const { return ranges[beam] >= range_max; }
};

/// At least this share of the beams must tell something.
inline constexpr double kLeastTellingShare = 0.5;
/// No scanner in the plane has more beams, or sees farther; what measures more is broken.
inline constexpr std::size_t kMostBeams = 20'000;
inline constexpr double kFarthestRange = 500;  ///< m; readings from here on saw nothing

/// Whether the robot may move by this scan. A beam tells something if it hit, or if it met nothing
/// within range (infinity, REP-117); NaN, minus infinity (too near to measure) and zero do not. A
/// scan in which too few tell something is no free way: it counts as none at all.
bool IsUsable(const LaserScan& scan);

/// For people: how much of the scan tells something, as "0 of 541 beams tell something".
std::string WhatTells(const LaserScan& scan);

/// The points that the scan hit, in base_link, nearer than `limit` [m] to the scanner.
std::vector<Point2D> PointsInBase(const LaserScan& scan, double limit);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_LASER_SCAN_H_
