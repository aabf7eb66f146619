// Navigator on the action servers move_base (move_base_msgs) and motion (coppice_msgs). With a real
// robot the first one is the real move_base.
#ifndef COPPICE_ROBOT_APP_ROS_ROS_NAVIGATOR_H_
#define COPPICE_ROBOT_APP_ROS_ROS_NAVIGATOR_H_

#include <memory>

#include "bt_nodes/docking/charging_station.h"
#include "bt_nodes/navigation/navigator.h"

namespace ros {
class NodeHandle;
}

namespace coppice::robot::adapters {

std::unique_ptr<leaves::Navigator> MakeRosNavigator(ros::NodeHandle& node);

/// ChargingStation on the action server docking (coppice_msgs).
std::unique_ptr<leaves::ChargingStation> MakeRosChargingStation(ros::NodeHandle& node);

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ROS_NAVIGATOR_H_
