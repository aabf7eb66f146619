// How walls, doors, furniture, the floor and the ceiling look: patterns that follow from the place
// alone, so that they stay where they are when the camera moves.
#ifndef COPPICE_ROBOT_APP_SIMULATION_CAMERA_SURFACES_H_
#define COPPICE_ROBOT_APP_SIMULATION_CAMERA_SURFACES_H_

#include <algorithm>
#include <cstdint>

#include "robot_app/common/picture.h"
#include "robot_app/simulation/scene/scene.h"

namespace coppice::robot::simulation {

/// A number for some numbers: the same for the same, else as if drawn by lot.
inline std::uint64_t Mixed(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0) {
  std::uint64_t x = a * 0x9e3779b97f4a7c15U + b * 0xc2b2ae3d27d4eb4fU + c * 0x165667b19e3779f9U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// `light` times as bright; `light` is not negative.
inline Colour Lit(const Colour& colour, double light) {
  const int factor = static_cast<int>(light * 256);
  const auto channel = [factor](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::min(255, value * factor >> 8));
  };
  return {channel(colour[0]), channel(colour[1]), channel(colour[2])};
}

/// One upright line of a panel: what a column of a picture shows of it.
class PanelLine {
 public:
  /// `along` is how far from the beginning of its edge [m].
  PanelLine(const Panel& panel, double along);

  /// `height` above the floor [m].
  Colour At(double height) const;

 private:
  Material material_;
  Colour paint_;
  double top_;
  bool is_frame_ = false;    // of a door
  bool is_handle_ = false;   // stands on the line of a door's handle
  std::uint64_t sheet_ = 0;  // a poster that hangs here; 0: none
  int column_ = 0;           // of the poster's pattern; -1: its white border
};

Colour FloorAt(Vec2 point);
Colour CeilingAt(Vec2 point);
Colour SkyAt(Vec2 point);
/// The upper side of a piece of furniture or a box.
Colour RoofAt(const Panel& panel);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CAMERA_SURFACES_H_
