// What the monitors of energy read from ROS messages.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_POWER_MESSAGES_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_POWER_MESSAGES_H_

#include <actionlib_msgs/GoalStatusArray.h>

#include <vector>

#include "robot_app/monitoring/power/docking_monitor.h"

namespace coppice::robot::monitoring {

std::vector<GoalReport> FromMessage(const actionlib_msgs::GoalStatusArray& message);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_POWER_MESSAGES_H_
