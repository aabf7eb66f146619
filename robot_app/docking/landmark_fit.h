// The landmark laid on the ranges of a scan, for landmark.cc. In the scanner's frame.
#ifndef COPPICE_ROBOT_APP_DOCKING_LANDMARK_FIT_H_
#define COPPICE_ROBOT_APP_DOCKING_LANDMARK_FIT_H_

#include <optional>

#include "robot_app/docking/landmark.h"

namespace coppice::robot::docking {

/// Gauss-Newton from `start` (pose of the corner), then the tests of landmark.h, which are milder
/// if it is known that a landmark is there. The pose of the result is in the scanner's frame.
std::optional<LandmarkSighting> FitInScan(const LaserScan& scan, const LandmarkSettings& settings,
                                          const Pose2D& start, bool is_known);

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_LANDMARK_FIT_H_
