// Which voxels a map fills: of each key frame what its lidar saw, and its cameras.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_MAP_VOXELS_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_MAP_VOXELS_H_

#include <cstdint>

#include "robot_app/slam/map/slam_map.h"
#include "robot_app/slam/occupancy/voxel_map.h"

namespace coppice::robot::slam {

/// The key frame was taken at `pose`; `lidar` is given in base_link.
void Enter(const KeyFrame& key_frame, const Pose3& pose, const Eigen::Vector3d& lidar,
           VoxelMap& voxels);

/// The voxels of all key frames that lie in the map of session `of_session`.
VoxelMap VoxelsOf(const SlamMap& map, std::uint32_t of_session, const Eigen::Vector3d& lidar,
                  double resolution);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_MAP_VOXELS_H_
