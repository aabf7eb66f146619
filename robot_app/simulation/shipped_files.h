// The floor and the robot that programs are given by name: a file, or what is shipped; and the
// robot's description turned into the options of its simulation.
#ifndef COPPICE_ROBOT_APP_SIMULATION_SHIPPED_FILES_H_
#define COPPICE_ROBOT_APP_SIMULATION_SHIPPED_FILES_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/common/robot_description.h"
#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/world.h"

namespace coppice::robot::simulation {

inline constexpr char kInstitute[] = "institute";  ///< the shipped floor
inline constexpr char kSobi[] = "sobi";            ///< the shipped robot

/// kInstitute or a YAML file. The first of its problems, with file and line.
Expected<Floor> FindFloor(const std::string& name);

/// kSobi or a URDF file.
Expected<RobotDescription> FindRobot(const std::string& name);

/// Sets the robot's size and the places of its sensors. A problem if a sensor's frame is missing or
/// does not stand level.
Outcome Apply(const RobotDescription& robot, WorldOptions& options);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SHIPPED_FILES_H_
