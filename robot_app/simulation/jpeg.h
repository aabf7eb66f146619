// Pictures as JPEG files in memory (stb_image_write).
#ifndef COPPICE_ROBOT_APP_SIMULATION_JPEG_H_
#define COPPICE_ROBOT_APP_SIMULATION_JPEG_H_

#include <cstdint>
#include <vector>

#include "robot_app/simulation/camera.h"

namespace coppice::robot::simulation {

/// `quality` 1..100.
std::vector<std::uint8_t> EncodeJpeg(const Picture& picture, int quality = 70);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_JPEG_H_
