#include "robot_app/navigation/costmap.h"

#include <cmath>

namespace coppice::robot::navigation {

void Costmap::Update(const OccupancyGrid& map, const std::vector<int>& obstacles) {
  frame_ = map.frame;
  std::vector<std::uint8_t> blocked(frame_.size());
  for (int i = 0; i < frame_.size(); ++i) blocked[i] = map.Blocked(i) ? 1 : 0;
  for (const int index : obstacles) blocked[index] = 1;
  distance_ = DistanceTransform(frame_, blocked, settings_.inflation_radius);
  cost_.resize(distance_.size());
  for (std::size_t i = 0; i < cost_.size(); ++i) {
    const double over = distance_[i] - settings_.lethal_radius;
    if (over < 0) {
      cost_[i] = kLethal;
    } else if (distance_[i] >= static_cast<float>(settings_.inflation_radius)) {
      cost_[i] = 1;
    } else {
      cost_[i] =
          static_cast<float>(1 + settings_.near_cost * std::exp(-over / settings_.cost_falls_over));
    }
  }
}

}  // namespace coppice::robot::navigation
