#include "robot_app/perception/legs/scan_segments.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr float kGap = 0.08F;      // between neighbours of one thing at least [m] ...
constexpr float kGrazing = 1.5F;   // ... and so often the distance between two beams more
constexpr float kMostJump = 2.0F;  // m

float Jump(const LaserScan& scan, std::size_t from, std::ptrdiff_t step) {
  const std::size_t beside = from + static_cast<std::size_t>(step);  // wraps before the first
  if (beside >= scan.ranges.size()) return 0;
  if (scan.MetNothing(beside)) return kMostJump;
  if (!scan.Hit(beside)) return 0;
  return std::clamp(scan.ranges[beside] - scan.ranges[from], -kMostJump, kMostJump);
}

bool AreJoined(const ScanPoint& a, const ScanPoint& b, double increment) {
  if (b.beam != a.beam + 1) return false;
  const float spacing = a.at.norm() * static_cast<float>(std::abs(increment));
  return (a.at - b.at).norm() < kGap + kGrazing * spacing;
}

}  // namespace

void SegmentByJumps(const LaserScan& scan, double farthest, SegmentedScan& out) {
  out.points.clear();
  out.segments.clear();
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (!scan.Hit(i) || scan.ranges[i] > farthest) continue;
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Eigen::Vector2d at = Eigen::Vector2d(std::cos(angle), std::sin(angle)) * scan.ranges[i];
    out.points.push_back({at.cast<float>(), static_cast<std::uint32_t>(i)});
    const auto count = static_cast<std::uint32_t>(out.points.size());
    if (count > 1 &&
        AreJoined(out.points[count - 2], out.points[count - 1], scan.angle_increment)) {
      out.segments.back().end = count;
    } else {
      out.segments.push_back({count - 1, count, Jump(scan, i, -1), 0});
    }
  }
  for (ScanSegment& segment : out.segments) {
    segment.jump_after = Jump(scan, out.points[segment.end - 1].beam, 1);
  }
}

}  // namespace coppice::robot::perception
