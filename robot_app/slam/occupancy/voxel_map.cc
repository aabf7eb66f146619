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

// The smallest grid around what is known; leaves may be larger than a voxel.
GridFrame FrameOf(const octomap::OcTree& tree, const HeightBand& band) {
  double low_x = HUGE_VAL, low_y = HUGE_VAL, high_x = -HUGE_VAL, high_y = -HUGE_VAL;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const double half = leaf.getSize() / 2;
    if (leaf.getZ() + half <= band.low || leaf.getZ() - half >= band.high) continue;
    low_x = std::min(low_x, leaf.getX() - half);
    low_y = std::min(low_y, leaf.getY() - half);
    high_x = std::max(high_x, leaf.getX() + half);
    high_y = std::max(high_y, leaf.getY() + half);
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

void Enter(const octomap::OcTree::leaf_iterator& leaf, std::int8_t value, OccupancyGrid& grid) {
  const double half = leaf.getSize() / 2;
  const double inside = grid.frame.resolution / 2;
  const Cell low = grid.frame.CellAt(leaf.getX() - half + inside, leaf.getY() - half + inside);
  const Cell high = grid.frame.CellAt(leaf.getX() + half - inside, leaf.getY() + half - inside);
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (!grid.frame.Contains({x, y})) continue;
      std::int8_t& cell = grid.cells[static_cast<std::size_t>(grid.frame.Index({x, y}))];
      cell = std::max(cell, value);
    }
  }
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
  tree_->updateInnerOccupancy();
  OccupancyGrid grid;
  grid.frame = FrameOf(*tree_, band);
  grid.cells.assign(static_cast<std::size_t>(grid.frame.size()), -1);
  for (auto leaf = tree_->begin_leafs(); leaf != tree_->end_leafs(); ++leaf) {
    const double half = leaf.getSize() / 2;
    if (leaf.getZ() + half <= band.low || leaf.getZ() - half >= band.high) continue;
    Enter(leaf, tree_->isNodeOccupied(*leaf) ? std::int8_t{100} : std::int8_t{0}, grid);
  }
  return grid;
}

Outcome VoxelMap::Save(const std::string& file) const {
  std::ostringstream bytes;
  if (!tree_->writeBinary(bytes)) return Problem{file + ": the map cannot be written"};
  Diagnostics diagnostics;
  if (WriteFile(file, bytes.str(), diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

}  // namespace coppice::robot::slam
