// The circle that explains echoes of the laser best: people, their legs and columns are round, and
// from afar a round thing looks like a flat corner. For landmark.cc.
#ifndef COPPICE_ROBOT_APP_DOCKING_CIRCLE_FIT_H_
#define COPPICE_ROBOT_APP_DOCKING_CIRCLE_FIT_H_

#include <vector>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::docking {

/// How far the echoes deviate along their beams from the best circle, bulging towards the scanner,
/// root of the mean square [m]; very large if there is none. `echoes` in the scanner's frame.
/// Least squares by Levenberg and Marquardt, from the algebraic fit of Kasa (A Circle Fitting
/// Procedure and Its Error Analysis, IEEE Transactions on Instrumentation and Measurement 25
/// (1976)).
double DeviationFromCircle(const std::vector<Point2D>& echoes);

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_CIRCLE_FIT_H_
