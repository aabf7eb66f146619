#include "robot_app/slam/map/slam_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::robot::slam {
namespace {

float Centimetres(float metres) { return std::round(metres * 100) / 100; }

std::array<int, 3> VoxelOf(const Eigen::Vector3f& point, float edge) {
  return {static_cast<int>(std::floor(point.x() / edge)),
          static_cast<int>(std::floor(point.y() / edge)),
          static_cast<int>(std::floor(point.z() / edge))};
}

}  // namespace

CloudPoints Thinned(const CloudPoints& points, float edge, float range) {
  std::vector<std::pair<std::array<int, 3>, Eigen::Vector3f>> sorted;
  for (const Eigen::Vector3f& point : points) {
    if (!point.allFinite() || point.head<2>().norm() > range) continue;
    sorted.push_back({VoxelOf(point, edge), point});
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  CloudPoints thin;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i > 0 && sorted[i].first == sorted[i - 1].first) continue;
    thin.push_back(sorted[i].second.unaryExpr(&Centimetres));
  }
  return thin;
}

}  // namespace coppice::robot::slam
