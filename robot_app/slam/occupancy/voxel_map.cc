#include "robot_app/slam/occupancy/voxel_map.h"

#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bt_core/model/write_file.h"

namespace coppice::robot::slam {
namespace {

// People walk through: what was seen empty later is empty.
constexpr double kHit = 0.65;
constexpr double kMiss = 0.42;

// What of the voxels is looked at, and along which axis (0: x): that between two bounds [m]. The
// other two axes are those of the grid.
struct Look {
  int right = 0, up = 1, through = 2;
  double low = 0, high = 0;
};

using Leaf = octomap::OcTree::leaf_iterator;

// getCoordinate() has no more digits than a float.
double At(const Leaf& leaf, int axis) {
  return axis == 0 ? leaf.getX() : axis == 1 ? leaf.getY() : leaf.getZ();
}

bool IsSeen(const Leaf& leaf, const Look& look) {
  const double half = leaf.getSize() / 2, at = At(leaf, look.through);
  return at + half > look.low && at - half < look.high;
}

// The smallest grid around what is known; leaves may be larger than a voxel.
GridFrame FrameOf(const octomap::OcTree& tree, const Look& look) {
  double low_x = HUGE_VAL, low_y = HUGE_VAL, high_x = -HUGE_VAL, high_y = -HUGE_VAL;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!IsSeen(leaf, look)) continue;
    const double half = leaf.getSize() / 2;
    low_x = std::min(low_x, At(leaf, look.right) - half);
    low_y = std::min(low_y, At(leaf, look.up) - half);
    high_x = std::max(high_x, At(leaf, look.right) + half);
    high_y = std::max(high_y, At(leaf, look.up) + half);
  }
  GridFrame frame;
  frame.resolution = tree.getResolution();
  if (low_x > high_x) return frame;
  const double cells = (high_x - low_x) / frame.resolution * ((high_y - low_y) / frame.resolution);
  if (cells > VoxelMap::kMostCells) return frame;
  frame.origin_x = low_x;
  frame.origin_y = low_y;
  frame.width = static_cast<int>(std::lround((high_x - low_x) / frame.resolution));
  frame.height = static_cast<int>(std::lround((high_y - low_y) / frame.resolution));
  return frame;
}

void Enter(const Leaf& leaf, const Look& look, std::int8_t value, OccupancyGrid& grid) {
  const double half = leaf.getSize() / 2;
  const double inside = half - grid.frame.resolution / 2;
  const double right = At(leaf, look.right), up = At(leaf, look.up);
  const Cell low = grid.frame.CellAt(right - inside, up - inside);
  const Cell high = grid.frame.CellAt(right + inside, up + inside);
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (!grid.frame.Contains({x, y})) continue;
      std::int8_t& cell = grid.cells[static_cast<std::size_t>(grid.frame.Index({x, y}))];
      cell = std::max(cell, value);
    }
  }
}

OccupancyGrid GridOf(octomap::OcTree& tree, const Look& look) {
  tree.updateInnerOccupancy();
  OccupancyGrid grid;
  grid.frame = FrameOf(tree, look);
  grid.cells.assign(static_cast<std::size_t>(grid.frame.size()), -1);
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!IsSeen(leaf, look)) continue;
    Enter(leaf, look, tree.isNodeOccupied(*leaf) ? std::int8_t{100} : std::int8_t{0}, grid);
  }
  return grid;
}

}  // namespace

VoxelMap::VoxelMap(double resolution) : tree_(std::make_unique<octomap::OcTree>(resolution)) {
  tree_->setProbHit(kHit);
  tree_->setProbMiss(kMiss);
}
VoxelMap::VoxelMap(VoxelMap&&) noexcept = default;
VoxelMap& VoxelMap::operator=(VoxelMap&&) noexcept = default;
VoxelMap::~VoxelMap() = default;

double VoxelMap::resolution() const { return tree_->getResolution(); }

void VoxelMap::Add(const std::vector<Eigen::Vector3f>& points, const Pose3& pose,
                   const Eigen::Vector3d& sensor, double range) {
  octomap::Pointcloud cloud;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d there = pose * point.cast<double>();
    cloud.push_back(static_cast<float>(there.x()), static_cast<float>(there.y()),
                    static_cast<float>(there.z()));
  }
  const Eigen::Vector3d from = pose * sensor;
  tree_->insertPointCloud(
      cloud,
      octomap::point3d(static_cast<float>(from.x()), static_cast<float>(from.y()),
                       static_cast<float>(from.z())),
      range, true, true);
}

OccupancyGrid VoxelMap::Project(const HeightBand& band) const {
  return GridOf(*tree_, {0, 1, 2, band.low, band.high});
}

OccupancyGrid VoxelMap::Section(const Cut& cut) const {
  const int along = cut.along_x ? 0 : 1;
  return GridOf(*tree_,
                {along, 2, 1 - along, cut.at - cut.thickness / 2, cut.at + cut.thickness / 2});
}

Outcome VoxelMap::Save(const std::string& file) const {
  std::ostringstream bytes;
  if (!tree_->writeBinary(bytes)) return Problem{file + ": the map cannot be written"};
  Diagnostics diagnostics;
  if (WriteFile(file, bytes.str(), diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

}  // namespace coppice::robot::slam
