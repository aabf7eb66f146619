// What one or two segments of a scan look like, in numbers that a classifier can learn from: are
// they the legs of one person?
#ifndef COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_FEATURES_H_
#define COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_FEATURES_H_

#include <array>
#include <optional>

#include "robot_app/perception/legs/scan_segments.h"

namespace coppice::robot::perception {

/// Of one segment: how many points, how wide, how they scatter, how straight, how round and with
/// which radius, how even and how bent, the jumps at both ends, how far away. After K. O. Arras, O.
/// Martinez Mozos and W. Burgard, "Using Boosted Features for the Detection of People in 2D Range
/// Data", ICRA 2007.
inline constexpr int kSegmentFeatures = 14;
/// Of a candidate: those of its nearer segment, those of the other one or zeros, and how the two
/// stand to each other.
inline constexpr int kLegFeatures = 2 * kSegmentFeatures + 4;

using LegFeatures = std::array<float, kLegFeatures>;

/// One segment, or two by their index: who stands may show one leg, or both as one.
struct LegCandidate {
  std::uint32_t first = 0;
  std::optional<std::uint32_t> second;
};

/// The middle of what is seen of a segment [m].
Eigen::Vector2f MiddleOf(const SegmentedScan& scan, const ScanSegment& segment);
/// From its first point to its last [m].
float WidthOf(const SegmentedScan& scan, const ScanSegment& segment);

LegFeatures Describe(const SegmentedScan& scan, const LegCandidate& candidate);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_FEATURES_H_
