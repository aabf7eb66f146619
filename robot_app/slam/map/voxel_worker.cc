#include "robot_app/slam/map/voxel_worker.h"

#include <utility>

#include "robot_app/slam/map/map_voxels.h"

namespace coppice::robot::slam {

VoxelWorker::VoxelWorker(double resolution, const Eigen::Vector3d& lidar)
    : resolution_(resolution), lidar_(lidar), thread_([this] { Work(); }) {}

VoxelWorker::~VoxelWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void VoxelWorker::Clear() {
  Do([this](VoxelMap& voxels) { voxels = VoxelMap(resolution_); });
}

void VoxelWorker::Add(std::shared_ptr<const KeyFrame> key_frame, const Pose3& pose) {
  Do([this, key_frame = std::move(key_frame), pose](VoxelMap& voxels) {
    Enter(*key_frame, pose, lidar_, voxels);
  });
}

void VoxelWorker::Project(std::function<void(const OccupancyGrid&)> done) {
  Do([done = std::move(done)](VoxelMap& voxels) { done(voxels.Project()); });
}

bool VoxelWorker::IsIdle() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tasks_.empty();
}

void VoxelWorker::Do(Task task) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_one();
}

void VoxelWorker::Work() {
  VoxelMap voxels(resolution_);
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_over_ || !tasks_.empty(); });
    if (is_over_) return;
    const Task task = std::move(tasks_.front());
    lock.unlock();
    task(voxels);
    lock.lock();
    tasks_.pop_front();
  }
}

}  // namespace coppice::robot::slam
