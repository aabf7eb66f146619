// A simulated camera: what the robot would see of the floor, drawn column by column. Good enough
// for a person to drive by; deterministic, without noise.
//
// For every column of the picture one ray is cast at every surface; surfaces stand upright on the
// floor, so each fills one stretch of the column (as in the games of 1992, but with heights).
#ifndef COPPICE_ROBOT_APP_SIMULATION_CAMERA_H_
#define COPPICE_ROBOT_APP_SIMULATION_CAMERA_H_

#include <array>
#include <cstdint>
#include <vector>

#include "robot_app/simulation/world.h"

namespace coppice::robot::simulation {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

/// Rows from the top, three bytes a pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  Colour at(int column, int row) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(row) * width + column);
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

struct CameraOptions {
  int width = 320;
  int height = 240;
  double field_of_view = 1.4;  ///< horizontal [rad]
  double lens_height = 0.9;    ///< above the floor [m]
  Pose2 mounting{0.2, 0, 0};   ///< in base_link; looks along its yaw, level
};

/// What a camera on the robot sees.
Picture RenderPicture(const World& world, const CameraOptions& options);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CAMERA_H_
