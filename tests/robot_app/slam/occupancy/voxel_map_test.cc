#include "robot_app/slam/occupancy/voxel_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/temporary_folder.h"

namespace coppice::robot::slam {
namespace {

const Eigen::Vector3d kSensor(0, 0, 1.2);

// What a lidar sees of a wall at x = 3 and of a table's edge at x = 2, y = 1, 0.7 m high.
std::vector<Eigen::Vector3f> WallAndTable() {
  std::vector<Eigen::Vector3f> points;
  for (float y = -2; y <= 2; y += 0.05F) {
    for (float z = 0.05F; z < 2.4F; z += 0.1F) points.emplace_back(3.05F, y, z);
  }
  for (float y = 0.8F; y < 1.2F; y += 0.05F) points.emplace_back(2.05F, y, 0.7F);
  return points;
}

std::int8_t At(const OccupancyGrid& grid, double x, double y) {
  const Cell cell = grid.frame.CellAt(x, y);
  return grid.frame.Contains(cell) ? grid.cells[static_cast<std::size_t>(grid.frame.Index(cell))]
                                   : std::int8_t{-1};
}

TEST(VoxelMap, WhatStandsInTheWayIsOccupiedAndWhatIsSeenThroughIsFree) {
  VoxelMap map(0.1);
  for (int i = 0; i < 3; ++i) map.Add(WallAndTable(), Pose3::Identity(), kSensor, 10);
  const OccupancyGrid grid = map.Project();
  EXPECT_EQ(At(grid, 3.05, 0), 100);
  EXPECT_EQ(At(grid, 2.05, 1), 100);  // the wall is seen above it
  EXPECT_EQ(At(grid, 1.5, 0), 0);
  EXPECT_EQ(At(grid, 3.4, 0), -1);
}

TEST(VoxelMap, WhatIsHigherThanTheRobotIsNotInItsWay) {
  VoxelMap map(0.1);
  map.Add(WallAndTable(), Pose3::Identity(), kSensor, 10);
  EXPECT_EQ(At(map.Project({0.12, 0.6}), 2.05, 1), 0);  // below the table's edge
}

TEST(VoxelMap, ASectionShowsHowHighThingsAre) {
  VoxelMap map(0.1);
  for (int i = 0; i < 3; ++i) map.Add(WallAndTable(), Pose3::Identity(), kSensor, 10);
  const OccupancyGrid along_x = map.Section({true, 1.0});
  EXPECT_EQ(At(along_x, 2.05, 0.7), 100);
  EXPECT_EQ(At(along_x, 2.05, 1.5), 0);  // the wall is seen above the table
  EXPECT_EQ(At(along_x, 3.05, 2.0), 100);
  EXPECT_EQ(At(along_x, 3.4, 1.0), -1);
  const OccupancyGrid beside = map.Section({true, 0});
  EXPECT_EQ(At(beside, 2.05, 0.7), 0);
  const OccupancyGrid along_y = map.Section({false, 3.05, 0.1});
  EXPECT_EQ(At(along_y, -1.5, 1.0), 100);
  EXPECT_EQ(At(along_y, -2.5, 1.0), -1);
  EXPECT_EQ(map.Section({true, 30}).frame.size(), 0);
}

TEST(VoxelMap, PointsBeyondTheRangeOnlySayThatItIsFree) {
  VoxelMap map(0.1);
  map.Add(WallAndTable(), Pose3::Identity(), kSensor, 2.5);
  const OccupancyGrid grid = map.Project();
  EXPECT_NE(At(grid, 3.05, 0), 100);
  EXPECT_EQ(At(grid, 1.5, 0), 0);
}

TEST(VoxelMap, ThereIsNoGridForWhatLiesKilometresApart) {
  VoxelMap map(0.1);
  Pose3 far = Pose3::Identity();
  far.translation() << 3000, 3000, 0;
  map.Add(WallAndTable(), Pose3::Identity(), kSensor, 10);
  map.Add(WallAndTable(), far, kSensor, 10);
  EXPECT_EQ(map.Project().frame.size(), 0);
}

TEST(VoxelMap, TheMapIsWhereTheRobotWas) {
  VoxelMap map(0.1);
  Pose3 pose = Pose3::Identity();
  pose.translation() << 10, 20, 0;
  pose.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  map.Add(WallAndTable(), pose, kSensor, 10);
  EXPECT_EQ(At(map.Project(), 10, 23.05), 100);
}

TEST(VoxelMap, WhoHasGoneIsGone) {
  VoxelMap map(0.1);
  map.Add({{1.55F, 0, 1.0F}}, Pose3::Identity(), kSensor, 10);
  EXPECT_EQ(At(map.Project(), 1.55, 0), 100);
  for (int i = 0; i < 4; ++i) map.Add(WallAndTable(), Pose3::Identity(), kSensor, 10);
  EXPECT_EQ(At(map.Project(), 1.55, 0), 0);
}

TEST(VoxelMap, AMapOfNothingIsEmpty) { EXPECT_EQ(VoxelMap().Project().frame.size(), 0); }

TEST(VoxelMap, ItIsSavedAsOctoMapReadsIt) {
  const TemporaryFolder folder;
  VoxelMap map;
  map.Add(WallAndTable(), Pose3::Identity(), kSensor, 10);
  ASSERT_TRUE(map.Save(folder.Path("map.bt")));
  EXPECT_EQ(ReadFile(folder.Path("map.bt")).rfind("# Octomap OcTree binary file", 0), 0U);
  EXPECT_FALSE(map.Save("/nowhere/map.bt"));
}

}  // namespace
}  // namespace coppice::robot::slam
