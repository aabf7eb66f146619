// Shifts a pose a little so that the scan lies on the walls of the map.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_SCAN_MATCHER_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_SCAN_MATCHER_H_

#include <Eigen/Core>
#include <vector>

#include "robot_app/localization/beams.h"

namespace coppice::robot::localization {

struct MatchSettings {
  int iterations = 20;
  double outlier = 0.3;     ///< ends farther from every wall do not pull [m]
  double beam_noise = 0.1;  ///< of a beam's end; small against `trust`: the scan decides [m]
  double trust = 0.3;       ///< standard deviation of the given position [m]
  double yaw_trust = 0.15;  ///< and yaw [rad]
};

/// The pose near `pose` at which the beams that hit lie nearest to walls, by Gauss-Newton on the
/// distance field (S. Kohlbrecher et al.: A Flexible and Scalable SLAM System with Full 3D Motion
/// Estimation, SSRR 2011). The given pose counts as a measurement too: along a bare corridor the
/// pose stays as it is. Finds the right place from about 0.2 m and 0.1 rad away.
Pose2D MatchScan(const LikelihoodField& field, const std::vector<Beam>& beams, const Pose2D& pose,
                 const MatchSettings& settings = {});

/// How firmly the beams alone hold a matched pose: the inverse covariance of x, y [m] (axes of the
/// map) and yaw [rad]. Along a bare corridor there is next to nothing of it.
Eigen::Matrix3d MatchInformation(const LikelihoodField& field, const std::vector<Beam>& beams,
                                 const Pose2D& pose, const MatchSettings& settings = {});

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_SCAN_MATCHER_H_
