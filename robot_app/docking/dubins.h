// The shortest ways of a vehicle that drives forwards and turns no tighter than in a circle (L. E.
// Dubins: On Curves of Minimal Length with a Constraint on Average Curvature, and with Prescribed
// Initial and Terminal Positions and Tangents, American Journal of Mathematics 79 (1957)). Each
// consists of three parts, arcs to the left (L) or right (R) and straight stretches (S): one of
// LSL, RSR, LSR, RSL, RLR, LRL. With the formulas of A. M. Shkel and V. Lumelsky (Classification of
// the Dubins set, Robotics and Autonomous Systems 34 (2001)). Pure functions.
#ifndef COPPICE_ROBOT_APP_DOCKING_DUBINS_H_
#define COPPICE_ROBOT_APP_DOCKING_DUBINS_H_

#include <array>
#include <string>
#include <vector>

#include "robot_app/common/pose2d.h"

namespace coppice::robot::docking {

struct DubinsPath {
  struct Part {
    int turn = 0;       ///< 1 left, -1 right, 0 straight on
    double length = 0;  ///< [m]
  };

  Pose2D from;
  double radius = 1;  ///< of the arcs [m]
  std::array<Part, 3> parts;

  double length() const;
  /// After `way` metres; at either end it goes no farther.
  Pose2D At(double way) const;
  /// "LSR" and the like.
  std::string word() const;
};

/// Of every word that leads there, the shortest first; at least one.
std::vector<DubinsPath> DubinsPaths(const Pose2D& from, const Pose2D& to, double radius);

}  // namespace coppice::robot::docking

#endif  // COPPICE_ROBOT_APP_DOCKING_DUBINS_H_
