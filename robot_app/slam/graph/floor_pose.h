// Poses of a robot on its floor, in space.
#ifndef COPPICE_ROBOT_APP_SLAM_GRAPH_FLOOR_POSE_H_
#define COPPICE_ROBOT_APP_SLAM_GRAPH_FLOOR_POSE_H_

#include <cmath>

#include "robot_app/common/pose2d.h"
#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

/// The same pose in space, on the floor.
inline Pose3 ToPose3(const Pose2D& pose) {
  Pose3 result = Pose3::Identity();
  result.translation() << pose.x, pose.y, 0;
  result.linear() = Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return result;
}

/// What of it a robot on the floor can tell.
inline Pose2D ToPose2D(const Pose3& pose) {
  return {pose.translation().x(), pose.translation().y(),
          std::atan2(pose.linear()(1, 0), pose.linear()(0, 0))};
}

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_GRAPH_FLOOR_POSE_H_
