// The straight stretches of a laser scan: what is needed to recognize things that were built.
//
// Where a surface ends is told by adaptive breakpoints (G. A. Borges, M.-J. Aldon: Line Extraction
// in 2D Range Images for Mobile Robotics, Journal of Intelligent and Robotic Systems 40 (2004)).
// Each surface is then cut into the lines that explain it best: of all ways to cut it, the one with
// the least sum of squared deviations and a price for each line (optimal partitioning; B. Jackson
// et al.: An Algorithm for Optimal Partitioning of Data on an Interval, IEEE Signal Processing
// Letters 12 (2005)). Unlike split and merge this finds a corner to the beam, and needs no
// threshold of length. Lines are fitted by total least squares. Pure functions; some milliseconds
// for a scan of 541 beams.
#ifndef COPPICE_ROBOT_APP_DOCKING_LINE_SEGMENTS_H_
#define COPPICE_ROBOT_APP_DOCKING_LINE_SEGMENTS_H_

#include <vector>

#include "robot_app/common/laser_scan.h"

namespace coppice::robot::docking {

struct LineSegment {
  Point2D from;    ///< where it begins counter-clockwise, in the scanner's frame [m]
  Point2D to;      ///< and where it ends
  int points = 0;  ///< that lie on it, at least 2
};

/// In the order of the beams. `noise`: standard deviation of a range [m]; beams that see farther
/// than `limit` [m] are left out.
std::vector<LineSegment> FindSegments(const LaserScan& scan, double noise, double limit);

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_LINE_SEGMENTS_H_
