// The voxels of a map that is still being made: key frames are entered where they lie now.
//
// Those that have moved cannot be taken out of the voxels; then all are entered anew, some at a
// time, so that not too much is read from the disk at once.
//
//   VoxelDrawing voxels(0.1, {0, 0, 1.2});
//   voxels.DrawSome(graph, frame, key_frame);             // now and then
//   voxels.Show(graph.poses().size(), [](const OccupancyGrid& grid) { ... });
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_VOXEL_DRAWING_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_VOXEL_DRAWING_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/slam/graph/session_graph.h"
#include "robot_app/slam/map/voxel_worker.h"

namespace coppice::robot::slam {

/// Of one thread; the work is done on another one.
class VoxelDrawing {
 public:
  using KeyFrames = std::function<Expected<std::shared_ptr<const KeyFrame>>(std::uint32_t)>;

  /// Edge of a voxel [m]; the lidar in base_link.
  VoxelDrawing(double resolution, const Eigen::Vector3d& lidar) : worker_(resolution, lidar) {}

  /// Enters some of the newest session's map that is not there yet, or lies elsewhere than it was
  /// entered; `frame`: of that map, in the frame of the voxels. What `key_frame` does not have is
  /// left out.
  void DrawSome(const SessionGraph& graph, const Pose3& frame, const KeyFrames& key_frame);

  /// Hands the floor plan to `done`, on another thread, when all of so many key frames are entered
  /// and something was since the last time. False: it does not.
  bool Show(std::size_t key_frames, std::function<void(const OccupancyGrid&)> done);

 private:
  VoxelWorker worker_;
  std::vector<Pose3> drawn_;  // where key frames were entered, of the first ones
  std::uint32_t map_ = 0;     // that is drawn
  std::size_t shown_ = 0;     // key frames
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_VOXEL_DRAWING_H_
