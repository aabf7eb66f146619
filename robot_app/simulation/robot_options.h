// The robot's description turned into the options of its simulation.
#ifndef COPPICE_ROBOT_APP_SIMULATION_ROBOT_OPTIONS_H_
#define COPPICE_ROBOT_APP_SIMULATION_ROBOT_OPTIONS_H_

#include "bt_core/base/outcome.h"
#include "robot_app/common/robot_description.h"
#include "robot_app/simulation/world.h"

namespace coppice::robot::simulation {

/// Sets the robot's size and the places of its sensors. A problem if a sensor's frame is missing or
/// does not stand level.
Outcome Apply(const RobotDescription& robot, WorldOptions& options);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_ROBOT_OPTIONS_H_
