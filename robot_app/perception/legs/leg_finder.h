// Finds people by their legs in the scans of a planar laser.
//
//   LegFinder finder({}, std::move(*LegClassifier::Load(file)));
//   for (const SeenLegs& person : finder.Find(scan)) ...
#ifndef COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_FINDER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_FINDER_H_

#include <vector>

#include "robot_app/perception/legs/leg_classifier.h"

namespace coppice::robot::perception {

struct LegFinderOptions {
  float least_probability = 0.6F;
  float farthest = 8;  ///< [m]; farther away too few beams meet a leg
};

struct SeenLegs {
  Eigen::Vector2f position{0, 0};  ///< of the body's axis, in the scanner's frame [m]
  Eigen::Matrix2f covariance = Eigen::Matrix2f::Identity();  ///< [m^2]
  float probability = 0;                                     ///< 0..1
  std::uint32_t beam = 0;                                    ///< that met the person
  LegCandidate legs;
};

class LegFinder {
 public:
  LegFinder(const LegFinderOptions& options, LegClassifier classifier)
      : options_(options), classifier_(std::move(classifier)) {}

  /// Who is seen in this scan, surest first; nobody twice. Valid until the next call. `scan` must
  /// be usable (laser_scan.h).
  const std::vector<SeenLegs>& Find(const LaserScan& scan);

  const LegFinderOptions& options() const { return options_; }

 private:
  LegFinderOptions options_;
  LegClassifier classifier_;
  SegmentedScan segmented_;
  std::vector<SeenLegs> sure_;
  std::vector<SeenLegs> people_;
};

/// What could be the legs of somebody: each small segment, and each two that stand no farther from
/// each other than a step is long.
std::vector<LegCandidate> LegCandidatesIn(const SegmentedScan& scan);

/// Whether the laser cannot see that place (in its frame) now: something stands before it, or it is
/// beside or farther away than the laser looks for legs.
bool IsHidden(const LaserScan& scan, float farthest, const Eigen::Vector2d& at);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_FINDER_H_
