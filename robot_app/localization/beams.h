// Beams of one scan or of several, spread over what they see, and how well they agree with the map.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_BEAMS_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_BEAMS_H_

#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/localization/likelihood_field.h"

namespace coppice::robot::localization {

/// From the scanner to where the beam ended, both in base_link (of one instant) [m].
struct Beam {
  Point2D from;
  Point2D to;
  bool hit = true;  ///< false: it met nothing up to `to`
};

/// Beams whose ends are about `spacing` [m] or more apart, at most about `most` of them, so that a
/// wall counts by its length and not by how near it is. Beams that met nothing come every few
/// degrees. Readings that are not numbers or too near are left out.
std::vector<Beam> BeamsOf(const LaserScan& scan, double spacing, int most);

/// The beams as seen from another base_link: `shift` is the pose of the old base_link in the new.
std::vector<Beam> Moved(const std::vector<Beam>& beams, const Pose2D& shift);

/// How the beams fit the map if base_link is at `pose`.
struct Agreement {
  int agree = 0;    ///< end at a wall of the map, on a free way
  int hidden = 0;   ///< end early: somebody stands there, or a door is closed
  int through = 0;  ///< went through a wall of the map: that cannot be
  /// 0..1. What stands in the way says little about where the robot is; going through a wall much.
  double score() const;
  /// The plain share of the beams that agree, 0..1: to compare two places.
  double share() const;
};
Agreement Agree(const LikelihoodField& field, const std::vector<Beam>& beams, const Pose2D& pose);

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_BEAMS_H_
