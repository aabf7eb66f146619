// Enters key frames into voxels on a thread of its own: each takes 20 to 30 ms indoors, and more
// where the lidar sees far. Neither the robot's pose nor the next key frame should wait for that.
//
//   VoxelWorker voxels(0.1, {0, 0, 1.2});
//   voxels.Add(key_frame, pose);
//   voxels.Project([](const OccupancyGrid& grid) { ... });     // of all that was added before
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_VOXEL_WORKER_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_VOXEL_WORKER_H_

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "robot_app/slam/map/slam_map.h"
#include "robot_app/slam/occupancy/voxel_map.h"

namespace coppice::robot::slam {

/// Of one thread at a time. What it is told is done in this order.
class VoxelWorker {
 public:
  /// Edge of a voxel [m]; the lidar in base_link.
  VoxelWorker(double resolution, const Eigen::Vector3d& lidar);
  /// What is not done yet is left, but for what has begun.
  ~VoxelWorker();

  void Clear();
  void Add(std::shared_ptr<const KeyFrame> key_frame, const Pose3& pose);
  /// `done` is called on the worker's thread, once what was added is in the grid.
  void Project(std::function<void(const OccupancyGrid&)> done);

  /// Nothing is left to do.
  bool IsIdle() const;

 private:
  using Task = std::function<void(VoxelMap&)>;
  void Do(Task task);
  void Work();

  const double resolution_;
  const Eigen::Vector3d lidar_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;  // the first one may be under way
  bool is_over_ = false;
  std::thread thread_;  // last: it uses all of them
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_VOXEL_WORKER_H_
