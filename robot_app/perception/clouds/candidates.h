// What in a cloud may be a person: clusters of about the size, found in both ways of clusters.h.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_CANDIDATES_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_CANDIDATES_H_

#include <vector>

#include "robot_app/perception/clouds/clusters.h"

namespace coppice::robot::perception {

struct CandidateOptions {
  LidarGeometry geometry;
  GroundOptions ground;
  DepthStepOptions depth_steps;
  DistanceOptions distance;
  bool with_depth_steps = true;  ///< off: clusters by distance alone, to see what the picture adds
};

class CandidateFinder {
 public:
  explicit CandidateFinder(const CandidateOptions& options) : options_(options) {}

  /// The groups of cells of this turn that may be one person each; the same person may be in
  /// several. Valid until the next call.
  const Clusters& Find(const std::vector<LidarPoint>& points);

  // --- of the last call ---
  const RangeImage& image() const { return image_; }
  const std::vector<Surface>& surfaces() const { return surfaces_; }
  const Clusters& candidates() const { return candidates_; }

 private:
  CandidateOptions options_;
  RangeImage image_;
  std::vector<Surface> surfaces_;
  Clusters clusters_;
  Clusters candidates_;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_CANDIDATES_H_
