#include "robot_app/navigation/way_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace coppice::robot::navigation {
namespace {

constexpr double kNear = 1;  // of a place, for a cell that is free [m]
constexpr float kNoWay = std::numeric_limits<float>::infinity();
constexpr Cell kAround[8] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

// The nearest cell around a point for which `is_free` holds.
template <typename IsFree>
std::optional<Cell> Nearest(const GridFrame& frame, Point2D point, IsFree is_free) {
  const Cell middle = frame.CellAt(point.x, point.y);
  const int reach = static_cast<int>(std::ceil(kNear / frame.resolution));
  std::optional<Cell> best;
  double nearest = kNear;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const double distance = Distance(frame.Center({x, y}), point);
      if (distance > nearest || !frame.Contains({x, y}) || !is_free(Cell{x, y})) continue;
      nearest = distance;
      best = Cell{x, y};
    }
  }
  return best;
}

using Entry = std::pair<float, int>;  // cost, index of the cell
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

// Costs decide which way; what is kept is its length.
class Spread {
 public:
  Spread(const Costmap& costmap, std::vector<float>& length)
      : costmap_(costmap), length_(length), cost_(length.size(), kNoWay) {}

  void From(Cell start) {
    const int first = costmap_.frame().Index(start);
    cost_[first] = length_[first] = 0;
    open_.push({0, first});
    while (!open_.empty()) {
      const auto [cost, index] = open_.top();
      open_.pop();
      if (cost <= cost_[index]) Expand(index);
    }
  }

 private:
  void Expand(int index) {
    const GridFrame& frame = costmap_.frame();
    const Cell cell = frame.CellOf(index);
    for (const Cell& step : kAround) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      const bool cuts_corner =
          costmap_.Lethal(Cell{next.x, cell.y}) || costmap_.Lethal(Cell{cell.x, next.y});
      if (costmap_.Lethal(next) || cuts_corner) continue;
      const int to = frame.Index(next);
      const double way = std::hypot(step.x, step.y) * frame.resolution;
      const auto cost =
          static_cast<float>(cost_[index] + way * 0.5 * (costmap_.cost(index) + costmap_.cost(to)));
      if (cost >= cost_[to]) continue;
      cost_[to] = cost;
      length_[to] = static_cast<float>(length_[index] + way);
      open_.push({cost, to});
    }
  }

  const Costmap& costmap_;
  std::vector<float>& length_;
  std::vector<float> cost_;
  Queue open_;
};

}  // namespace

WayField::WayField(const Costmap& costmap, Point2D to)
    : frame_(costmap.frame()), length_(frame_.size(), kNoWay) {
  const auto end = Nearest(frame_, to, [&](Cell cell) { return !costmap.Lethal(cell); });
  if (!end) return;
  last_step_ = Distance(frame_.Center(*end), to);
  Spread(costmap, length_).From(*end);
}

std::optional<double> WayField::Length(Point2D from) const {
  if (!std::isfinite(from.x) || !std::isfinite(from.y)) return std::nullopt;
  const Cell cell = frame_.CellAt(from.x, from.y);
  if (!frame_.Contains(cell)) return std::nullopt;
  const float length = length_[frame_.Index(cell)];
  if (length == kNoWay) return NearestLength(from);
  return length + last_step_;
}

std::optional<double> WayField::NearestLength(Point2D from) const {
  const auto start =
      Nearest(frame_, from, [&](Cell cell) { return length_[frame_.Index(cell)] != kNoWay; });
  if (!start) return std::nullopt;
  return Distance(frame_.Center(*start), from) + length_[frame_.Index(*start)] + last_step_;
}

}  // namespace coppice::robot::navigation
