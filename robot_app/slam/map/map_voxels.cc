#include "robot_app/slam/map/map_voxels.h"

namespace coppice::robot::slam {

void Enter(const KeyFrame& key_frame, const Pose3& pose, const Eigen::Vector3d& lidar,
           VoxelMap& voxels) {
  voxels.Add(key_frame.points, pose, lidar, key_frame.range);
  for (const CameraCloud& cloud : key_frame.camera_clouds) {
    voxels.Add(cloud.points, pose, cloud.camera.cast<double>(), key_frame.range);
  }
}

VoxelMap VoxelsOf(const SlamMap& map, std::uint32_t of_session, const Eigen::Vector3d& lidar,
                  double resolution) {
  const SessionGraph graph({}, map.graph, map.sessions);
  VoxelMap voxels(resolution);
  for (std::size_t i = 0; i < map.key_frames.size(); ++i) {
    if (graph.map_of(map.sessions[i]) != graph.map_of(of_session)) continue;
    Enter(*map.key_frames[i], map.graph.poses[i], lidar, voxels);
  }
  return voxels;
}

}  // namespace coppice::robot::slam
