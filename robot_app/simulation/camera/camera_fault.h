// What can ail a simulated camera.
#ifndef COPPICE_ROBOT_APP_SIMULATION_CAMERA_CAMERA_FAULT_H_
#define COPPICE_ROBOT_APP_SIMULATION_CAMERA_CAMERA_FAULT_H_

namespace coppice::robot::simulation {

struct CameraFault {
  bool is_covered = false;  ///< something hangs over the lenses
  double broken = 0;        ///< share of the rows whose data is damaged on the way, 0..1
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CAMERA_CAMERA_FAULT_H_
