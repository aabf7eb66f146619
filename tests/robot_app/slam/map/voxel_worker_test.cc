#include "robot_app/slam/map/voxel_worker.h"

#include <gtest/gtest.h>

#include <future>

namespace coppice::robot::slam {
namespace {

const Eigen::Vector3d kLidar{0, 0, 1.2};

// A wall across the way, `ahead` metres before the robot.
std::shared_ptr<const KeyFrame> WallAt(float ahead) {
  auto key_frame = std::make_shared<KeyFrame>();
  key_frame->range = 8;
  for (float y = -1; y < 1; y += 0.05F) key_frame->points.emplace_back(ahead, y, 1.0F);
  return key_frame;
}

OccupancyGrid GridOf(VoxelWorker& worker) {
  std::promise<OccupancyGrid> promise;
  worker.Project([&promise](const OccupancyGrid& grid) { promise.set_value(grid); });
  return promise.get_future().get();
}

std::int8_t At(const OccupancyGrid& grid, double x, double y) {
  const Cell cell = grid.frame.CellAt(x, y);
  return grid.frame.Contains(cell) ? grid.cells[grid.frame.Index(cell)] : std::int8_t{-1};
}

TEST(VoxelWorker, ProjectsAllThatWasAddedBefore) {
  VoxelWorker worker(0.1, kLidar);
  worker.Add(WallAt(2.05F), Pose3::Identity());
  Pose3 farther = Pose3::Identity();
  farther.translation().x() = -3;
  worker.Add(WallAt(1.05F), farther);
  const OccupancyGrid grid = GridOf(worker);
  EXPECT_EQ(At(grid, 2.05, 0), 100);
  EXPECT_EQ(At(grid, -1.95, 0), 100);
  EXPECT_EQ(At(grid, 1.5, 0), 0);
}

TEST(VoxelWorker, BeginsAnewWhenItIsCleared) {
  VoxelWorker worker(0.1, kLidar);
  worker.Add(WallAt(2.05F), Pose3::Identity());
  worker.Clear();
  EXPECT_EQ(GridOf(worker).frame.size(), 0);
  worker.Add(WallAt(1.05F), Pose3::Identity());
  EXPECT_EQ(At(GridOf(worker), 1.05, 0), 100);
}

TEST(VoxelWorker, EndsThoughMuchIsLeftToDo) {
  bool was_projected = false;
  {
    std::promise<void> held;
    VoxelWorker worker(0.1, kLidar);
    std::promise<void> begun;
    worker.Project([&](const OccupancyGrid&) {
      begun.set_value();
      held.get_future().wait();
    });
    begun.get_future().wait();
    EXPECT_FALSE(worker.IsIdle());
    for (int i = 0; i < 1000; ++i) worker.Add(WallAt(2.05F), Pose3::Identity());
    worker.Project([&](const OccupancyGrid&) { was_projected = true; });
    held.set_value();
  }
  EXPECT_FALSE(was_projected);
}

}  // namespace
}  // namespace coppice::robot::slam
