#include "robot_app/navigation/obstacle_layer.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::navigation {

void ObstacleLayer::Insert(const Pose2D& pose, const LaserScan& scan) {
  const Pose2D laser = Compose(pose, scan.mount);
  const Point2D from{laser.x, laser.y};
  const GridFrame& frame = marks_.frame();
  std::vector<int> hits;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (std::isnan(range) || range < scan.range_min) continue;
    const bool hit = scan.Hit(i) && range <= settings_.mark_range;
    const double length = std::min({range, scan.range_max, settings_.clear_range});
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Point2D end = Compose(laser, Point2D{length * std::cos(angle), length * std::sin(angle)});
    TraceLine(frame, from, end, [&](Cell cell) {
      if (!frame.Contains(cell)) return false;
      marks_.Unmark(frame.Index(cell));
      return true;
    });
    const Cell last = frame.CellAt(end.x, end.y);
    if (hit && frame.Contains(last)) hits.push_back(frame.Index(last));
  }
  // Cells left marked first, then the hits: one beam must not clear what its neighbour has hit.
  marks_.KeepIf([](int) { return true; });
  for (const int index : hits) marks_.Mark(index, scan.stamp);
}

}  // namespace coppice::robot::navigation
