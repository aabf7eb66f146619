// A turn of the lidar takes a tenth of a second. In a robot that turns meanwhile it is bent: a wall
// begins and ends at different angles. Each point is moved to where it would have been seen from at
// the stamp of the cloud.
#ifndef COPPICE_ROBOT_APP_SLAM_STRAIGHTENED_CLOUD_H_
#define COPPICE_ROBOT_APP_SLAM_STRAIGHTENED_CLOUD_H_

#include <vector>

#include "robot_app/localization/pose_history.h"
#include "robot_app/perception/clouds/range_image.h"
#include "robot_app/slam/clouds/cloud_descriptor.h"
#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

/// The points that met something, in base_link as it was at `stamp`. `lidar`: its pose in
/// base_link. Points of a time that the odometry does not cover stay as they were measured.
CloudPoints Straightened(const std::vector<perception::LidarPoint>& points, const Pose3& lidar,
                         double stamp, const localization::PoseHistory& odometry);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_STRAIGHTENED_CLOUD_H_
