// A scan of a planar laser, cut where the range jumps: each piece is one side of one thing.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_LEGS_SCAN_SEGMENTS_H_
#define COPPICE_ROBOT_APP_PERCEPTION_LEGS_SCAN_SEGMENTS_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "robot_app/common/laser_scan.h"

namespace coppice::robot::perception {

struct ScanPoint {
  Eigen::Vector2f at{0, 0};  ///< in the scanner's frame [m]
  std::uint32_t beam = 0;
};

/// The points `begin` up to `end` of the scan. A jump tells how much farther than the segment's end
/// the next beam beside it goes [m], at most 2; negative: something nearer hides more of it; 0:
/// that beam tells nothing.
struct ScanSegment {
  std::uint32_t begin = 0, end = 0;
  float jump_before = 0, jump_after = 0;
  std::uint32_t size() const { return end - begin; }
};

struct SegmentedScan {
  std::vector<ScanPoint> points;  ///< that were hit, counter-clockwise
  std::vector<ScanSegment> segments;
};

/// Points no farther than `farthest` [m] from the scanner. Neighbours are of one segment if they
/// are nearer to each other than a leg is thick; farther away, where beams are farther apart, by as
/// much more. `scan` must be usable (laser_scan.h).
void SegmentByJumps(const LaserScan& scan, double farthest, SegmentedScan& out);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_LEGS_SCAN_SEGMENTS_H_
