// The simulated cameras by name, and what can ail one.
#ifndef COPPICE_ROBOT_APP_SIMULATION_CAMERA_CAMERA_FAULT_H_
#define COPPICE_ROBOT_APP_SIMULATION_CAMERA_CAMERA_FAULT_H_

#include <array>

namespace coppice::robot::simulation {

/// /camera/NAME/..., mounted on the frame camera_NAME.
inline constexpr std::array<const char*, 2> kCameras = {"front", "rear"};

struct CameraFault {
  bool is_covered = false;  ///< something hangs over the lenses
  double broken = 0;        ///< share of the rows whose data is damaged on the way, 0..1
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CAMERA_CAMERA_FAULT_H_
