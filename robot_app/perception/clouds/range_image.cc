#include "robot_app/perception/clouds/range_image.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr float kPi = 3.14159265F;

}  // namespace

int ColumnOf(const Eigen::Vector2f& direction, const LidarGeometry& geometry) {
  const float share = (kPi - std::atan2(direction.y(), direction.x())) / (2 * kPi);
  return static_cast<int>(std::lround(share * static_cast<float>(geometry.columns))) %
         geometry.columns;
}

std::size_t FillRangeImage(const std::vector<LidarPoint>& points, const LidarGeometry& geometry,
                           RangeImage& image) {
  const std::size_t cells = static_cast<std::size_t>(geometry.rings) * geometry.columns;
  image.geometry = geometry;
  image.points.resize(cells);
  image.intensities.resize(cells);
  image.ranges.assign(cells, 0);
  std::size_t kept = 0;
  for (const LidarPoint& point : points) {
    const float range = std::sqrt(point.x * point.x + point.y * point.y + point.z * point.z);
    if (!std::isfinite(range) || range < geometry.min_range || point.ring >= geometry.rings) {
      continue;
    }
    const std::size_t cell = image.cell(point.ring, ColumnOf({point.x, point.y}, geometry));
    if (image.ranges[cell] > 0 && image.ranges[cell] <= range) continue;
    kept += image.ranges[cell] > 0 ? 0 : 1;
    image.ranges[cell] = range;
    image.points[cell] = {point.x, point.y, point.z + geometry.height};
    image.intensities[cell] = point.intensity;
  }
  return kept;
}

}  // namespace coppice::robot::perception
