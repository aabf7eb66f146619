#include "robot_app/slam/map/map_voxels.h"

#include <gtest/gtest.h>

#include "tests/robot_app/slam/map/small_map.h"

namespace coppice::robot::slam {
namespace {

const Eigen::Vector3d kLidar{0, 0, 1.2};

std::int8_t At(const VoxelMap& voxels, double x, double y) {
  const OccupancyGrid grid = voxels.Project();
  const Cell cell = grid.frame.CellAt(x, y);
  return grid.frame.Contains(cell) ? grid.cells[grid.frame.Index(cell)] : std::int8_t{-1};
}

// A box of 30 cm, which the beams of the lidar pass above on their way to a wall.
KeyFrame BoxBeforeAWall() {
  KeyFrame seen;
  seen.range = 8;
  for (float y = -1; y < 1; y += 0.05F) seen.points.emplace_back(3.05F, y, 1.0F);
  seen.camera_clouds = {{{0.2F, 0, 0.6F}, {}}};
  for (float y = -0.2F; y < 0.2F; y += 0.05F) {
    for (float z = 0.02F; z < 0.3F; z += 0.05F) {
      seen.camera_clouds[0].points.emplace_back(1.55F, y, z);
    }
  }
  return seen;
}

TEST(MapVoxels, WhatOnlyACameraSeesIsInTheWay) {
  VoxelMap voxels(0.1), without(0.1);
  KeyFrame seen = BoxBeforeAWall();
  Enter(seen, Pose3::Identity(), kLidar, voxels);
  EXPECT_EQ(At(voxels, 1.55, 0), 100);
  EXPECT_EQ(At(voxels, 3.05, 0), 100);
  seen.camera_clouds.clear();
  Enter(seen, Pose3::Identity(), kLidar, without);
  EXPECT_EQ(At(without, 1.55, 0), 0);
}

TEST(MapVoxels, BetweenTheCameraAndWhatItSeesItIsFree) {
  KeyFrame seen = BoxBeforeAWall();
  seen.points.clear();
  VoxelMap voxels(0.1);
  Enter(seen, Pose3::Identity(), kLidar, voxels);
  EXPECT_EQ(At(voxels, 0.85, 0), 0);
  EXPECT_EQ(At(voxels, 2.55, 0), -1);
}

TEST(MapVoxels, OfAMapThoseSessionsAreEnteredThatLieInIt) {
  SlamMap map = SmallMap();
  const std::size_t together = VoxelsOf(map, 0, kLidar, 0.1).Project().cells.size();
  map.graph.links.pop_back();  // what joins them
  EXPECT_LT(VoxelsOf(map, 0, kLidar, 0.1).Project().cells.size(), together);
}

}  // namespace
}  // namespace coppice::robot::slam
