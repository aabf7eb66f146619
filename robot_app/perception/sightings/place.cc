#include "robot_app/perception/sightings/place.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr double kMiddle = 0.6;  // share of the box, in both directions, as in the paper's code
constexpr std::size_t kLeastPoints = 4;
constexpr double kBodyBehind = 0.1;  // of the surface that is seen is the axis [m]
constexpr double kFaceBehind = 0.07;
constexpr double kAlong = 0.09;        // standard deviation of the distance [m]
constexpr double kAlongDepth = 0.004;  // and of depth pictures, at 1 m; grows with the square
constexpr double kAcross = 0.05;       // of the direction [m],
constexpr double kAcrossBox = 0.1;     // and as a share of the box

Box MiddleOf(const Box& box) {
  const double width = kMiddle * box.width;
  const double height = kMiddle * box.height;
  return {box.x + (box.width - width) / 2, box.y + (box.height - height) / 2, width, height};
}

// Rounded into the picture.
int Inside(double pixel, int size) {
  return static_cast<int>(std::clamp(std::ceil(pixel), 0.0, static_cast<double>(size)));
}

std::vector<float> DepthsIn(const Box& box, const DepthPicture& picture) {
  std::vector<float> depths;
  const int right = Inside(box.right(), picture.width);
  const int bottom = Inside(box.bottom(), picture.height);
  for (int row = Inside(box.y, picture.height); row < bottom; ++row) {
    for (int column = Inside(box.x, picture.width); column < right; ++column) {
      const double depth = picture.at(column, row) / 1e3;
      if (depth > 0 && depth <= kFarthestDepth) depths.push_back(static_cast<float>(depth));
    }
  }
  return depths;
}

std::vector<float> LidarDepthsIn(const Box& box, const Ranges& ranges) {
  std::vector<float> depths;
  for (const Eigen::Vector3f& point : ranges.lidar) {
    if (!(point.z() > 0)) continue;  // NaN too
    const double x = ranges.lens.cx + ranges.lens.fx * point.x() / point.z();
    const double y = ranges.lens.cy + ranges.lens.fy * point.y() / point.z();
    const bool is_in = x >= box.x && x < box.right() && y >= box.y && y < box.bottom();
    if (is_in) depths.push_back(point.z());
  }
  return depths;
}

double Median(std::vector<float>& numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// Along and across the line of sight.
Eigen::Matrix2d Covariance(const Eigen::Vector2d& line, double along, double across) {
  Eigen::Matrix2d axes;
  axes << line.x(), -line.y(), line.y(), line.x();
  const Eigen::Vector2d squares(along * along, across * across);
  return axes * squares.asDiagonal() * axes.transpose();
}

Place At(const Sighting& sighting, const Ranges& ranges, double depth, RangedBy by) {
  const Box& box = sighting.box;
  const Lens& lens = ranges.lens;
  const Eigen::Vector3d surface(depth * (box.x + box.width / 2 - lens.cx) / lens.fx,
                                depth * (box.y + box.height / 2 - lens.cy) / lens.fy, depth);
  const Eigen::Vector2d eye = ranges.optical_in_frame.translation().head<2>();
  const Eigen::Vector2d seen = (ranges.optical_in_frame * surface).head<2>();
  const Eigen::Vector2d line = (seen - eye).normalized();
  const double noise = by == RangedBy::kDepth ? kAlongDepth * depth * depth : 0;
  const double across = kAcross + kAcrossBox * box.width * depth / lens.fx;
  Place place;
  place.position =
      seen + line * (sighting.kind == SightingKind::kPerson ? kBodyBehind : kFaceBehind);
  place.covariance = Covariance(line, std::hypot(kAlong, noise), across);
  place.by = by;
  return place;
}

}  // namespace

std::optional<Place> PlaceOf(const Sighting& sighting, const Ranges& ranges) {
  const Box middle = MiddleOf(sighting.box);
  std::vector<float> by_depth = DepthsIn(middle, ranges.depth);
  std::vector<float> by_lidar = LidarDepthsIn(middle, ranges);
  const bool is_depth = by_depth.size() > by_lidar.size();
  std::vector<float>& depths = is_depth ? by_depth : by_lidar;
  if (depths.size() < kLeastPoints) return std::nullopt;
  const RangedBy by = is_depth ? RangedBy::kDepth : RangedBy::kLidar;
  return At(sighting, ranges, Median(depths), by);
}

}  // namespace coppice::robot::perception
