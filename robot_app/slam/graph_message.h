// Poses and the graph of a map as ROS sends them.
#ifndef COPPICE_ROBOT_APP_SLAM_GRAPH_MESSAGE_H_
#define COPPICE_ROBOT_APP_SLAM_GRAPH_MESSAGE_H_

#include <geometry_msgs/Pose.h>
#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "robot_app/slam/graph/session_graph.h"

namespace coppice::robot::slam {

geometry_msgs::Pose ToPoseMessage(const Pose3& pose);

/// For RViz: the links of the newest session's map, those of the odometry in blue, closures by
/// pictures in red and by clouds in green. `at`: the map in the frame of that name.
visualization_msgs::MarkerArray MarkersOf(const SessionGraph& graph, const std::string& frame,
                                          const Pose3& at, const ros::Time& stamp);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_GRAPH_MESSAGE_H_
