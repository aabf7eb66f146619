// Recognizes the landmark of the charging station in a scan of the planar laser.
//
// Line segments (line_segments.h) that meet in a corner of about the right opening are candidates.
// Each is fitted to the ranges by Gauss-Newton, and must then pass: the beams that should meet it
// do (or something nearer hides it, but not much of it), none looks through it, what they measure
// deviates from it by no more than noise, and beyond its ends the room is farther away. So no
// corner of a wall, piece of furniture or pair of legs is taken for it.
//
// Pure functions without a clock, a thread or ROS.
#ifndef COPPICE_ROBOT_APP_DOCKING_LANDMARK_H_
#define COPPICE_ROBOT_APP_DOCKING_LANDMARK_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/common/places/landmark_shape.h"

namespace coppice::robot::docking {

struct LandmarkSettings {
  LandmarkShape shape;
  double noise = 0.01;  ///< standard deviation of a range [m]
  double limit = 5;     ///< is not looked for farther away [m]
};

struct LandmarkSighting {
  Pose2D pose;                 ///< of its corner in base_link; the x axis points into the station
  Eigen::Matrix3d covariance;  ///< of x, y, yaw [m, rad]
  int points = 0;              ///< beams that met it
  double deviation = 0;        ///< of what they measured, root of the mean square [m]
};

/// All that are seen, usually one or none.
std::vector<LandmarkSighting> FindLandmarks(const LaserScan& scan,
                                            const LandmarkSettings& settings);

/// The landmark that is expected about there (corner in base_link, as LandmarkSighting::pose; up to
/// 0.1 m and 10 degrees off); nothing if it does not pass. Needs fewer beams than FindLandmarks.
std::optional<LandmarkSighting> FitLandmark(const LaserScan& scan, const LandmarkSettings& settings,
                                            const Pose2D& expected);

/// base_link when docked, from the pose of the corner, both in the same frame; and back.
Pose2D DockedAt(const LandmarkShape& shape, const Pose2D& landmark);
Pose2D LandmarkOf(const LandmarkShape& shape, const Pose2D& docked);

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_LANDMARK_H_
