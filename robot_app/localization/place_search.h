// Looks for all places on the whole map where the beams fit.
//
// Every position of a 0.1 m grid and every heading in steps of 3 degrees is considered, but most
// are excluded many at once: the best that a whole square of positions can reach is bounded by the
// best likelihood near each beam's end (branch and bound on correlative scan matching: E. B. Olson,
// Real-Time Correlative Scan Matching, ICRA 2009; W. Hess et al., Real-Time Loop Closure in 2D
// LIDAR SLAM, ICRA 2016).
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_PLACE_SEARCH_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_PLACE_SEARCH_H_

#include <cstdint>
#include <vector>

#include "robot_app/localization/beams.h"

namespace coppice::robot::localization {

/// A pose of base_link in the map frame, and how well the beams fit there.
struct FittingPlace {
  Pose2D pose;
  Agreement agreement;
};

/// Two places count as the same if they are nearer than this [m], [rad].
inline constexpr double kSamePlace = 0.6;
inline constexpr double kSameHeading = 0.5;
bool IsSamePlace(const Pose2D& a, const Pose2D& b);

class PlaceSearch {
 public:
  /// The field must outlive this object.
  explicit PlaceSearch(const LikelihoodField& field);

  /// The places where the largest share of the beams agrees, best first, at most `most`, none of
  /// them the same. Each is matched precisely. Places that fit much worse than the best may be
  /// missing. Some milliseconds; allocates.
  std::vector<FittingPlace> Find(const std::vector<Beam>& beams, std::size_t most) const;

 private:
  struct Level;
  struct Node;
  struct Turned;
  void Build();
  double Bound(const Turned& turned, int level, int column, int row) const;
  void Descend(const Turned& turned, const Node& node, double& threshold,
               std::vector<Node>& found) const;
  std::vector<Node> Coarse(const std::vector<Turned>& turns) const;

  const LikelihoodField& field_;
  int width_ = 0;
  int height_ = 0;
  // Of level i: the best likelihood, 0..255, and whether anything is free, in the square of 2^i
  // cells whose lower left cell this is.
  std::vector<std::vector<std::uint8_t>> best_;
  std::vector<std::vector<std::uint8_t>> free_;
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_PLACE_SEARCH_H_
