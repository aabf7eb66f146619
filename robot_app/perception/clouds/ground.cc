#include "robot_app/perception/clouds/ground.h"

#include <cmath>

namespace coppice::robot::perception {
namespace {

// The floor of one column as far as it has been followed, from the sensor's foot on.
struct Floor {
  float distance = 0;  // [m]
  float height = 0;
};

constexpr float kNoise = 0.06F;  // of a height, twice the standard deviation of a range [m]

bool GoesOn(const Floor& floor, float distance, float height, const GroundOptions& options) {
  const float rise = std::abs(height - floor.height);
  if (floor.distance <= 0) return rise <= options.start;
  return rise <= kNoise + options.slope * std::abs(distance - floor.distance);
}

}  // namespace

void FindGround(const RangeImage& image, const GroundOptions& options,
                std::vector<Surface>& surfaces) {
  surfaces.assign(image.size(), Surface::kNothing);
  for (int column = 0; column < image.geometry.columns; ++column) {
    Floor floor;
    for (int ring = 0; ring < image.geometry.rings; ++ring) {
      const std::size_t cell = image.cell(ring, column);
      if (image.ranges[cell] <= 0) continue;
      const Eigen::Vector3f& point = image.points[cell];
      const float distance = point.head<2>().norm();
      if (GoesOn(floor, distance, point.z(), options)) {
        surfaces[cell] = Surface::kFloor;
        floor = {distance, point.z()};
      } else {
        surfaces[cell] = point.z() > options.tallest ? Surface::kAbove : Surface::kStanding;
      }
    }
  }
}

}  // namespace coppice::robot::perception
