// The ground out of doors: how high it is over x, straight between the points of a profile and
// level beyond its ends. Everything stands upright on it; a robot stands as the ground under it
// leans, so that its level beams meet the ground where that rises before it.
//
//   const Ground ground({{0, 0}, {15, 0.785}});     // 3 degrees uphill to the east
//   ground.Cast({-2, 0}, {1, 0}, 0.3, 20);          // 7.7: 5.7 m behind the foot of the slope
//
// Metres in the frame `map`. Immutable.
#ifndef COPPICE_ROBOT_APP_SIMULATION_SCENE_GROUND_H_
#define COPPICE_ROBOT_APP_SIMULATION_SCENE_GROUND_H_

#include <vector>

#include "robot_app/simulation/scene/geometry.h"

namespace coppice::robot::simulation {

class Ground {
 public:
  /// Points (x, height), x ascending; none: it is level.
  explicit Ground(std::vector<Vec2> profile = {}) : profile_(std::move(profile)) {}

  double Height(double x) const;
  /// Rise per metre to the east.
  double Slope(double x) const;

  /// The range at which a beam from a sensor `height` above the ground meets the ground, at most
  /// `max_range`. `direction` has length 1.
  double Cast(Vec2 origin, Vec2 direction, double height, double max_range) const;

 private:
  std::vector<Vec2> profile_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SCENE_GROUND_H_
