#include "robot_app/perception/sightings/depth_turn.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::perception {
namespace {

constexpr float kIntensity = 40;  // of clothes in infrared light, as a Puck tells it

// How far along the optical axis; 0: outside of the picture, or not measured.
float DepthAt(const DepthPicture& depth, double x, double y) {
  const auto column = static_cast<int>(std::lround(x));
  const auto row = static_cast<int>(std::lround(y));
  const bool is_in = column >= 0 && column < depth.width && row >= 0 && row < depth.height;
  return is_in ? static_cast<float>(depth.at(column, row)) / 1e3F : 0;
}

}  // namespace

double HalfAngle(const Lens& lens, int width) {
  return std::min(std::atan2(lens.cx, lens.fx), std::atan2(width - lens.cx, lens.fx));
}

void TurnOf(const DepthPicture& depth, const Lens& lens, const LidarGeometry& geometry,
            double farthest, std::vector<LidarPoint>& points) {
  points.clear();
  const double widest =
      std::max(std::atan2(lens.cx, lens.fx), std::atan2(depth.width - lens.cx, lens.fx));
  const int columns = static_cast<int>(widest / geometry.column_step());
  for (int column = columns; column >= -columns; --column) {
    const double direction = column * geometry.column_step();  // positive: to the left
    for (int ring = 0; ring < geometry.rings; ++ring) {
      const double slope =
          std::tan((ring - (geometry.rings - 1) / 2.0) * geometry.ring_step) / std::cos(direction);
      const float along =
          DepthAt(depth, lens.cx - lens.fx * std::tan(direction), lens.cy - lens.fy * slope);
      if (!(along > 0 && along <= farthest)) continue;
      points.push_back({along, along * static_cast<float>(std::tan(direction)),
                        along * static_cast<float>(slope), kIntensity,
                        static_cast<std::uint16_t>(ring)});
    }
  }
}

}  // namespace coppice::robot::perception
