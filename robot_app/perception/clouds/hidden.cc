#include "robot_app/perception/clouds/hidden.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr float kHalfWidth = 0.2F;  // of a body [m]
constexpr float kBefore = 0.35F;    // what ends so much before the axis is something else [m]
constexpr float kLow = 0.6F;        // the heights of a body that are looked at [m]
constexpr float kHigh = 1.4F;

}  // namespace

bool IsHidden(const RangeImage& image, const Eigen::Vector2f& place) {
  const LidarGeometry& geometry = image.geometry;
  const float distance = place.norm();
  if (distance < geometry.min_range + kBefore) return true;
  const int middle = ColumnOf(place, geometry);
  const int half =
      static_cast<int>(std::asin(std::min(1.0F, kHalfWidth / distance)) / geometry.column_step());
  int rays = 0, blocked = 0;
  for (int column = middle - half; column <= middle + half; ++column) {
    for (int ring = 0; ring < geometry.rings; ++ring) {
      const float slope = (static_cast<float>(ring) - static_cast<float>(geometry.rings - 1) / 2) *
                          geometry.ring_step;
      const float height = geometry.height + distance * std::tan(slope);
      if (height < kLow || height > kHigh) continue;
      const std::size_t cell = image.cell(ring, column);
      ++rays;
      if (image.ranges[cell] > 0 && image.points[cell].head<2>().norm() < distance - kBefore) {
        ++blocked;
      }
    }
  }
  return 2 * blocked > rays;
}

}  // namespace coppice::robot::perception
