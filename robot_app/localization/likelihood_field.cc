#include "robot_app/localization/likelihood_field.h"

#include <algorithm>

namespace coppice::robot::localization {

LikelihoodField::LikelihoodField(const OccupancyGrid& map)
    : frame_(map.frame), free_(map.cells.size()) {
  std::vector<std::uint8_t> occupied(map.cells.size());
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    occupied[i] = map.cells[i] >= OccupancyGrid::kOccupied ? 1 : 0;
    free_[i] = !map.Blocked(static_cast<int>(i));
  }
  distance_ = DistanceTransform(frame_, occupied, kReach);
}

bool LikelihoodField::Free(double x, double y) const {
  const Cell cell = frame_.CellAt(x, y);
  return frame_.Contains(cell) && free_[frame_.Index(cell)];
}

LikelihoodField::Slope LikelihoodField::DistanceAndSlope(double x, double y) const {
  const double column = (x - frame_.origin_x) / frame_.resolution - 0.5;
  const double row = (y - frame_.origin_y) / frame_.resolution - 0.5;
  const Cell low{static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row))};
  const Cell high{low.x + 1, low.y + 1};
  if (!frame_.Contains(low) || !frame_.Contains(high)) return {};
  const float* below = distance_.data() + frame_.Index(low);
  const float* above = below + frame_.width;
  const double u = column - low.x;
  const double v = row - low.y;
  Slope slope;
  slope.distance =
      (1 - v) * ((1 - u) * below[0] + u * below[1]) + v * ((1 - u) * above[0] + u * above[1]);
  slope.along_x = ((1 - v) * (below[1] - below[0]) + v * (above[1] - above[0])) / frame_.resolution;
  slope.along_y = ((1 - u) * (above[0] - below[0]) + u * (above[1] - below[1])) / frame_.resolution;
  return slope;
}

double LikelihoodField::Cast(const Point2D& from, const Point2D& to) const {
  const double length = coppice::robot::Distance(from, to);
  if (!(length > 0)) return HUGE_VAL;
  const double along_x = (to.x - from.x) / length;
  const double along_y = (to.y - from.y) / length;
  for (double way = 0; way < length;) {
    const double distance = Distance(from.x + way * along_x, from.y + way * along_y);
    if (distance == 0) return way;
    // Both ends of that distance are middles of cells; we are somewhere in ours.
    way += std::max(distance - frame_.resolution, frame_.resolution / 2);
  }
  return HUGE_VAL;
}

}  // namespace coppice::robot::localization
