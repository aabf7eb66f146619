// From ROS topics to the robot's figures.
#ifndef COPPICE_ROBOT_APP_METRICS_METRICS_FEED_H_
#define COPPICE_ROBOT_APP_METRICS_METRICS_FEED_H_

#include <ros/node_handle.h>

#include <vector>

#include "robot_app/metrics/robot_metrics.h"

namespace coppice::robot::metrics {

/// /monitoring, /battery_state, /processes, /recovery/events, /assistance/requests and
/// /store/status, as long as the returned subscribers live; so long the metrics must live, too.
std::vector<ros::Subscriber> SubscribeMetrics(ros::NodeHandle& node, RobotMetrics& metrics);

}  // namespace coppice::robot::metrics

#endif  // COPPICE_ROBOT_APP_METRICS_METRICS_FEED_H_
