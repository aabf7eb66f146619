// The shape of a person who walks, as sensors at any height see it: legs that swing, torso, arms,
// head; each an upright pillar.
#ifndef COPPICE_ROBOT_APP_SIMULATION_SCENE_FIGURE_H_
#define COPPICE_ROBOT_APP_SIMULATION_SCENE_FIGURE_H_

#include <array>
#include <vector>

#include "robot_app/simulation/scene/ray_caster.h"

namespace coppice::robot::simulation {

/// Length of the way in which both legs do a step [m].
inline constexpr double kStride = 1.4;

/// Round, from a height up to another one.
struct Pillar {
  Disc disc;
  double bottom = 0;          ///< [m]
  double top = 0;             ///< [m]
  double reflectivity = 0.5;  ///< 0..1, for infrared light
};

struct Figure {
  Disc bounds;  ///< all parts are inside
  std::array<Pillar, 6> parts;
};

/// How a person stands or walks.
struct Stance {
  Vec2 position;         ///< in the map frame [m]
  double heading = 0;    ///< [rad]
  double walked = 0;     ///< length of the way so far [m]: in which part of a step the legs are
  bool walks = false;    ///< else the legs are side by side
  double height = 1.75;  ///< [m]
  double clothes = 0.4;  ///< reflectivity
};

Figure MakeFigure(const Stance& stance);
std::vector<Figure> MakeFigures(const std::vector<Stance>& stances);

/// What a level plane at `height` [m] cuts of the figures: below the hips the legs.
std::vector<Disc> SlicesAt(double height, const std::vector<Figure>& figures);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SCENE_FIGURE_H_
