// The ROS master that the robot needs: found or started.
#ifndef COPPICE_ROBOT_APP_PROCESSES_LAUNCH_ROS_MASTER_H_
#define COPPICE_ROBOT_APP_PROCESSES_LAUNCH_ROS_MASTER_H_

#include <string>

#include "robot_app/common/node_probe.h"
#include "robot_app/processes/launch/process_launcher.h"

namespace coppice::robot::processes {

/// A master on this computer.
struct RosMaster {
  NodeAddress address;
  int pid = 0;  ///< 0: it was there before us and is not ours to end

  std::string Uri() const;
};

/// The first of so many TCP ports in a row on which nobody listens on this computer; others at each
/// call, 0 if there are none. They lie below those that Linux gives to whoever connects: nobody is
/// given one before it is used.
int FreePort(int in_a_row = 1);

/// Uses the master that answers at `port`, else starts one there; port 0 takes a free one. Fails if
/// something else has the port, or if no master answers in time. Blocks until then.
Expected<RosMaster> FindOrStartMaster(int port, ProcessLauncher& launcher, Duration timeout);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_LAUNCH_ROS_MASTER_H_
