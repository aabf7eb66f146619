#include "robot_app/slam/map/slam_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace coppice::robot::slam {
namespace {

float Centimetres(float metres) { return std::round(metres * 100) / 100; }

constexpr std::int64_t kMiddle = std::int64_t{1} << 20;  // of 21 bits

// In the order of x, then y, then z.
struct Voxel {
  std::uint64_t number = 0;
  std::uint32_t point = 0;

  bool operator<(const Voxel& other) const {
    return number != other.number ? number < other.number : point < other.point;
  }
};

std::uint64_t NumberOf(const Eigen::Vector3f& point, float edge) {
  std::uint64_t number = 0;
  for (const float value : {point.x(), point.y(), point.z()}) {
    const auto step = static_cast<std::int64_t>(std::floor(value / edge)) + kMiddle;
    number = number << 21 | static_cast<std::uint64_t>(step);
  }
  return number;
}

}  // namespace

CloudPoints Thinned(const CloudPoints& points, float edge, float range) {
  std::vector<Voxel> voxels;
  voxels.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f& point = points[i];
    if (!(point.head<2>().norm() <= range) || !(std::abs(point.z()) <= range)) continue;
    const std::uint64_t number = NumberOf(point, edge);
    if (voxels.empty() || voxels.back().number != number) voxels.push_back({number, i});
  }
  std::sort(voxels.begin(), voxels.end());
  CloudPoints thin;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (i > 0 && voxels[i].number == voxels[i - 1].number) continue;
    thin.push_back(points[voxels[i].point].unaryExpr(&Centimetres));
  }
  return thin;
}

}  // namespace coppice::robot::slam
