// Brings the robot's pose to the trees, and how far it is to the charging station.
#ifndef COPPICE_ROBOT_APP_ROS_POSE_FEED_H_
#define COPPICE_ROBOT_APP_ROS_POSE_FEED_H_

#include <ros/node_handle.h>

#include <vector>

#include "bt_core/data/inbox.h"
#include "bt_nodes/navigation/pose2d.h"
#include "robot_app/navigation/ros_support.h"

namespace coppice::robot {

/// A tree that does not use a key gives an empty sender.
struct PoseKeys {
  Sender<coppice::Pose2D> pose;  ///< in the map frame
  /// Length of the way to the station [m], estimated: no map is asked.
  Sender<double> distance_to_station;
};

/// Estimated length of the way between two places in a building [m]: the straight line, and half
/// of it more for the corridors.
double EstimatedWay(const coppice::Pose2D& from, const coppice::Pose2D& to);

/// Twice a second from tf, as long as it lives; without tf nothing is sent.
class PoseFeed {
 public:
  /// `station`: a pose at the charging station, in the map frame.
  PoseFeed(ros::NodeHandle& node, const coppice::Pose2D& station, std::vector<PoseKeys> trees);

 private:
  void Send();

  coppice::Pose2D station_;
  std::vector<PoseKeys> trees_;
  RobotPose pose_{{"map", "odom", "base_link"}};
  ros::WallTimer timer_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_ROS_POSE_FEED_H_
