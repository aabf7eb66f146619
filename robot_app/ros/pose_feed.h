// Brings the robot's pose to the trees, and how far it is to the charging station.
#ifndef COPPICE_ROBOT_APP_ROS_POSE_FEED_H_
#define COPPICE_ROBOT_APP_ROS_POSE_FEED_H_

#include <ros/node_handle.h>

#include <mutex>
#include <vector>

#include "bt_core/data/inbox.h"
#include "bt_nodes/navigation/pose2d.h"
#include "bt_nodes/power/way_home.h"
#include "robot_app/common/ros_support.h"

namespace coppice::robot::adapters {

/// A tree that does not use a key gives an empty sender.
struct PoseKeys {
  Sender<leaves::Pose2D> pose;  ///< in the map frame
  /// Length of the way to the station [m], from the topic /navigation/way_to_station (on the map).
  /// While that is silent it is estimated: the straight line, and half of it more for the
  /// corridors.
  Sender<double> distance_to_station;
};

/// Twice a second from tf, as long as it lives; without tf nothing is sent.
class PoseFeed {
 public:
  /// `station`: a pose at the charging station, in the map frame.
  PoseFeed(ros::NodeHandle& node, const leaves::Pose2D& station, std::vector<PoseKeys> trees);

 private:
  double WayFrom(const leaves::Pose2D& pose);
  void Send();

  leaves::Pose2D station_;
  std::mutex mutex_;  // the spinner has two threads
  leaves::WayHome way_;
  ros::Subscriber measured_;
  std::vector<PoseKeys> trees_;
  RobotPose pose_{{"map", "odom", "base_link"}};
  ros::WallTimer timer_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_POSE_FEED_H_
