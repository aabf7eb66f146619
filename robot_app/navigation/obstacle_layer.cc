#include "robot_app/navigation/obstacle_layer.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::navigation {

void ObstacleLayer::Reset(const GridFrame& frame) {
  frame_ = frame;
  seen_.assign(frame.size(), kNever);
  marked_.clear();
}

void ObstacleLayer::Insert(const Pose2D& pose, const LaserScan& scan) {
  const Pose2D laser = Compose(pose, scan.mount);
  const Point2D from{laser.x, laser.y};
  std::vector<int> hits;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (std::isnan(range) || range < scan.range_min) continue;
    const bool hit = scan.Hit(i) && range <= settings_.mark_range;
    const double length = std::min({range, scan.range_max, settings_.clear_range});
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Point2D end = Compose(laser, Point2D{length * std::cos(angle), length * std::sin(angle)});
    TraceLine(frame_, from, end, [&](Cell cell) {
      if (!frame_.Contains(cell)) return false;
      seen_[frame_.Index(cell)] = kNever;
      return true;
    });
    const Cell last = frame_.CellAt(end.x, end.y);
    if (hit && frame_.Contains(last)) hits.push_back(frame_.Index(last));
  }
  // Cells left marked first, then the hits: one beam must not clear what its neighbour has hit.
  KeepIf([&](int index) { return seen_[index] != kNever; });
  for (const int index : hits) {
    if (seen_[index] == kNever) marked_.push_back(index);
    seen_[index] = scan.stamp;
  }
}

void ObstacleLayer::Forget(double now) {
  KeepIf([&](int index) { return now - seen_[index] <= settings_.forget_after; });
}

void ObstacleLayer::Clear() {
  KeepIf([](int) { return false; });
}

template <typename Keep>
void ObstacleLayer::KeepIf(Keep keep) {
  const auto gone = std::remove_if(marked_.begin(), marked_.end(), [&](int index) {
    if (keep(index)) return false;
    seen_[index] = kNever;
    return true;
  });
  marked_.erase(gone, marked_.end());
}

}  // namespace coppice::robot::navigation
