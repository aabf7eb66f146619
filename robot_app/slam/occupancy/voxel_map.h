// What is occupied and what is free in space, from turns of the lidar and pictures of depth; and
// what of it a robot on the floor has to know, as the grid that map server and navigation use.
//
// A. Hornung, K. M. Wurm, M. Bennewitz, C. Stachniss, W. Burgard: OctoMap: An Efficient
// Probabilistic 3D Mapping Framework Based on Octrees, Autonomous Robots 34 (2013) (liboctomap).
//
//   VoxelMap map(0.1);
//   map.Add(points, pose, {0, 0, 1.2}, 10);
//   const OccupancyGrid grid = map.Project({0.12, 1.5});
//   const OccupancyGrid side = map.Section({true, 2.0});     // along x at y = 2 m
#ifndef COPPICE_ROBOT_APP_SLAM_OCCUPANCY_VOXEL_MAP_H_
#define COPPICE_ROBOT_APP_SLAM_OCCUPANCY_VOXEL_MAP_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/occupancy_grid.h"
#include "robot_app/slam/graph/pose_graph.h"

namespace octomap {
class OcTree;
}

namespace coppice::robot::slam {

/// From where up to where something is in the robot's way [m].
struct HeightBand {
  double low = 0.12;
  double high = 1.5;
};

/// An upright cut through a map: along x at a y, or along y at an x.
struct Cut {
  bool along_x = true;
  double at = 0;           ///< y, or x [m]
  double thickness = 0.3;  ///< of what is shown, to both sides together [m]
};

/// Movable. Not thread-safe.
class VoxelMap {
 public:
  explicit VoxelMap(double resolution = 0.1);  ///< edge of a voxel [m]
  VoxelMap(VoxelMap&&) noexcept;
  VoxelMap& operator=(VoxelMap&&) noexcept;
  ~VoxelMap();

  static constexpr double kMostCells = 20e6;  ///< of a grid: 450 m by 450 m at 0.1 m

  /// `points` and the sensor are given in base_link, which was at `pose`. Between the sensor and a
  /// point it is free; points farther than `range` [m] say that it is free up to there. Some 30 ms
  /// for a turn of the lidar indoors.
  void Add(const std::vector<Eigen::Vector3f>& points, const Pose3& pose,
           const Eigen::Vector3d& sensor, double range);

  /// Seen from above: a cell is occupied if a voxel of the band is, free if one is free and none is
  /// occupied, else unknown. Only cells that are known are inside; empty if there are none, or if
  /// they lie so far apart that the grid would have more than kMostCells.
  OccupancyGrid Project(const HeightBand& band = {}) const;

  /// Seen from the side, in the same way: along the cut to the right, the height upwards.
  OccupancyGrid Section(const Cut& cut) const;

  /// Of the voxels.
  double resolution() const;

  /// OctoMap's own format (.bt), as octovis shows it; replaced at once.
  Outcome Save(const std::string& file) const;

 private:
  std::unique_ptr<octomap::OcTree> tree_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_OCCUPANCY_VOXEL_MAP_H_
