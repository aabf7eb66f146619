#include "robot_app/slam/map/voxel_drawing.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <optional>

namespace coppice::robot::slam {
namespace {

// A wall across the way, 2.05 m before the robot.
Expected<std::shared_ptr<const KeyFrame>> Wall(std::uint32_t) {
  auto key_frame = std::make_shared<KeyFrame>();
  key_frame->range = 8;
  for (float y = -1; y < 1; y += 0.05F) key_frame->points.emplace_back(2.05F, y, 1.0F);
  return std::shared_ptr<const KeyFrame>(std::move(key_frame));
}

Pose3 At(double x) {
  Pose3 pose = Pose3::Identity();
  pose.translation().x() = x;
  return pose;
}

class VoxelDrawingTest : public testing::Test {
 protected:
  // Draws all; the plan, if there is a new one.
  std::optional<OccupancyGrid> Plan(const Pose3& frame = Pose3::Identity()) {
    std::promise<OccupancyGrid> promise;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    const auto done = [&promise](const OccupancyGrid& grid) { promise.set_value(grid); };
    while (!voxels_.Show(graph_.poses().size(), done)) {
      if (std::chrono::steady_clock::now() > deadline) return std::nullopt;
      voxels_.DrawSome(graph_, frame, &Wall);
    }
    return promise.get_future().get();
  }
  static bool HasWall(const std::optional<OccupancyGrid>& grid, double x) {
    if (!grid) return false;
    const Cell cell = grid->frame.CellAt(x, 0);
    return grid->frame.Contains(cell) && grid->cells[grid->frame.Index(cell)] == 100;
  }

  SessionGraph graph_;
  VoxelDrawing voxels_{0.1, {0, 0, 1.2}};
};

TEST_F(VoxelDrawingTest, ShowsThePlanOnceAllIsEnteredAndAgainWhenThereIsMore) {
  for (int i = 0; i < 7; ++i) graph_.AddPose(At(i == 0 ? 0 : 1), InformationOf(0.1, 0.01));
  const auto plan = Plan();
  EXPECT_TRUE(HasWall(plan, 2.05));
  EXPECT_TRUE(HasWall(plan, 8.05));
  EXPECT_FALSE(voxels_.Show(7, [](const OccupancyGrid&) {}));
  graph_.AddPose(At(1), InformationOf(0.1, 0.01));
  EXPECT_FALSE(voxels_.Show(8, [](const OccupancyGrid&) {}));
  EXPECT_TRUE(HasWall(Plan(), 9.05));
}

TEST_F(VoxelDrawingTest, DrawsAllAnewWhereItLiesNowThoughNothingCame) {
  graph_.AddPose(Pose3::Identity(), InformationOf(0.1, 0.01));
  EXPECT_TRUE(HasWall(Plan(), 2.05));
  const auto plan = Plan(At(5));
  EXPECT_TRUE(HasWall(plan, 7.05));
  EXPECT_FALSE(HasWall(plan, 2.05));
}

TEST_F(VoxelDrawingTest, LeavesOutMapsThatTheNewestSessionIsNotJoinedWith) {
  graph_.AddPose(Pose3::Identity(), InformationOf(0.1, 0.01));
  EXPECT_TRUE(HasWall(Plan(), 2.05));
  graph_.BeginSession();
  graph_.AddPose(Pose3::Identity(), InformationOf(0.1, 0.01));
  graph_.AddPose(At(1), InformationOf(0.1, 0.01));
  const auto plan = Plan();
  EXPECT_TRUE(HasWall(plan, 3.05));
  graph_.BeginSession();
  graph_.AddPose(Pose3::Identity(), InformationOf(0.1, 0.01));
  EXPECT_FALSE(HasWall(Plan(), 3.05));
}

}  // namespace
}  // namespace coppice::robot::slam
