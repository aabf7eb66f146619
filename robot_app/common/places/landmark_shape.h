// The landmark of the charging station: what is built there, what the simulation raises, and what
// the robot looks for in its scans.
//
// A triangular prism on the floor, seen from above:
//
//            base_link of the docked robot -->         left of it
//                                               .|     y
//                    ahead                   .   |     ^
//          (o)-------------------------->  <     |     |
//                                   corner   .   |     +--> x
//                                               .|
//
// Its corner points to the robot, its two legs are what the laser sees. 150 degrees are an angle
// that no room has: walls and furniture meet at right angles, and people are rounder.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_LANDMARK_SHAPE_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_LANDMARK_SHAPE_H_

#include <cmath>

namespace coppice::robot {

struct LandmarkShape {
  double leg = 0.35;                  ///< length of each leg [m]
  double opening = 150 * M_PI / 180;  ///< between the legs, on the side of the station [rad]
  double ahead = 0.43;                ///< the corner before base_link when docked [m]

  /// Of the triangle, from its corner to its base, and half the length of the base [m].
  double depth() const { return leg * std::cos(opening / 2); }
  double half_width() const { return leg * std::sin(opening / 2); }
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_LANDMARK_SHAPE_H_
