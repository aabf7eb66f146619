#include "robot_app/localization/scan_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::robot::localization {
namespace {

constexpr double kOldest = 0.25;       // s; in that time people do not come far
constexpr double kFarthest = 0.15;     // m; what is near does not move aside by its own angle
constexpr double kNeighbours = 0.018;  // rad
constexpr double kAtLeast = 0.2;       // m
constexpr double kPerMetre = 0.1;

// What was met so far away, or nothing at all, counts as the same.
double RangeOf(const LaserScan& scan, std::size_t beam) {
  return scan.Hit(beam) ? scan.ranges[beam] : scan.range_max;
}

bool Readable(const LaserScan& scan, std::size_t beam) {
  return scan.ranges[beam] >= scan.range_min;  // not for NaN
}

}  // namespace

double ScanChange::Add(const LaserScan& scan, const Pose2D& odometry) {
  const LaserScan before = std::exchange(before_, scan);
  const double turn = NormalizeAngle(odometry.yaw - odometry_.yaw);
  const double way = Distance(odometry, odometry_);
  odometry_ = odometry;
  if (before.ranges.size() != scan.ranges.size() || !(scan.angle_increment > 0) ||
      std::abs(scan.stamp - before.stamp) > kOldest || way > kFarthest) {
    return 0;
  }
  const auto shift = static_cast<int>(std::lround(turn / scan.angle_increment));
  const int reach = static_cast<int>(std::ceil(kNeighbours / scan.angle_increment));
  const auto beams = static_cast<int>(scan.ranges.size());
  int compared = 0, changed = 0;
  for (int i = 0; i < beams; ++i) {
    if (!Readable(scan, i) || i + shift - reach < 0 || i + shift + reach >= beams) continue;
    const double range = RangeOf(scan, i);
    double least = HUGE_VAL;
    for (int j = i + shift - reach; j <= i + shift + reach; ++j) {
      if (Readable(before, j)) least = std::min(least, std::abs(RangeOf(before, j) - range));
    }
    ++compared;
    if (least > kAtLeast + kPerMetre * range) ++changed;
  }
  return compared > 0 ? static_cast<double>(changed) / compared : 0;
}

}  // namespace coppice::robot::localization
