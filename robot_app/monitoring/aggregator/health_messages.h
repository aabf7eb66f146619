// Findings and process states as ROS messages and back.
#ifndef COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_HEALTH_MESSAGES_H_
#define COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_HEALTH_MESSAGES_H_

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>

#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/finding.h"
#include "robot_app/monitoring/process_table.h"

namespace coppice::robot::monitoring {

/// A ROS time as nanoseconds, and back (negative times become zero).
Time FromRos(const ros::Time& time);
ros::Time ToRos(Time time);

/// The header is stamped with the current ROS time.
coppice_msgs::Health ToMessage(const std::string& source, const std::vector<Finding>& findings);
std::vector<Finding> FromMessage(const coppice_msgs::Health& message);

ProcessTable FromMessage(const coppice_msgs::ProcessStates& message);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_AGGREGATOR_HEALTH_MESSAGES_H_
