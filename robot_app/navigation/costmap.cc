#include "robot_app/navigation/costmap.h"

#include <cmath>

namespace coppice::robot::navigation {

void Costmap::Update(const OccupancyGrid& map, const std::vector<int>& obstacles) {
  frame_ = map.frame;
  std::vector<std::uint8_t> blocked(frame_.size());
  for (int i = 0; i < frame_.size(); ++i) blocked[i] = map.Blocked(i) ? 1 : 0;
  for (const int index : obstacles) blocked[index] = 1;
  cost_ = {};  // there is no room for three
  cost_ = DistanceTransform(frame_, blocked, settings_.inflation_radius);
  for (float& value : cost_) {  // a distance, which becomes a cost
    const double over = value - settings_.lethal_radius;
    if (over < 0) {
      value = kLethal;
    } else if (value >= static_cast<float>(settings_.inflation_radius)) {
      value = 1;
    } else {
      value =
          static_cast<float>(1 + settings_.near_cost * std::exp(-over / settings_.cost_falls_over));
    }
  }
}

}  // namespace coppice::robot::navigation
