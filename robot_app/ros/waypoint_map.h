// The topological map of robot_app/navigation as the WaypointMap that leaves call.
#ifndef COPPICE_ROBOT_APP_ROS_WAYPOINT_MAP_H_
#define COPPICE_ROBOT_APP_ROS_WAYPOINT_MAP_H_

#include <memory>
#include <string>

#include "bt_nodes/navigation/waypoint_map.h"

namespace coppice::robot::adapters {

/// Reads a waypoint file. The seed fixes the random order of the patrol. Throws std::runtime_error
/// with file:line and the reason if the file is not good.
std::unique_ptr<leaves::WaypointMap> LoadWaypointMap(const std::string& path, unsigned seed);

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_WAYPOINT_MAP_H_
