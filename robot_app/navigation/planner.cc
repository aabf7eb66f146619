#include "robot_app/navigation/planner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <queue>

namespace coppice::robot::navigation {
namespace {

constexpr double kDiagonal = 1.4142135623730951;
constexpr std::size_t kLongestLine = 1000;  // cells; all together take the square of it

/// The cells around a cell, the four straight ones first.
constexpr Cell kAround[8] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

std::string Print(const char* format, double a, double b, double c = 0) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

/// The middle of the nearest cell that is free, if one lies within `radius` [m] of the point.
std::optional<Cell> NearestFree(const Costmap& costmap, Point2D point, double radius) {
  const GridFrame& frame = costmap.frame();
  const Cell middle = frame.CellAt(point.x, point.y);
  const int reach = static_cast<int>(std::ceil(radius / frame.resolution));
  std::optional<Cell> best;
  double best_distance = radius;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      if (costmap.Lethal(Cell{x, y})) continue;
      const double distance = Distance(frame.Center({x, y}), point);
      if (distance > best_distance) continue;
      best_distance = distance;
      best = Cell{x, y};
    }
  }
  return best;
}

Plan GoalBlocked(const Costmap& costmap, Point2D goal) {
  constexpr double kSearch = 3.0;
  Plan plan;
  plan.status = PlanStatus::kGoalBlocked;
  plan.message = Print("the goal (%.2f, %.2f) is blocked; ", goal.x, goal.y);
  const auto free = NearestFree(costmap, goal, kSearch);
  plan.message += free ? Print("the nearest free place is %.2f m away",
                               Distance(costmap.frame().Center(*free), goal), 0)
                       : Print("nothing is free within %.0f m", kSearch, 0);
  return plan;
}

class Search {
 public:
  Search(const Costmap& costmap, Cell start, Cell goal)
      : costmap_(costmap), frame_(costmap.frame()), start_(start), goal_(goal) {}

  /// Cost of the cheapest way, or infinity.
  double Run() {
    best_.assign(frame_.size(), std::numeric_limits<float>::infinity());
    from_.assign(frame_.size(), -1);
    best_[frame_.Index(start_)] = 0;
    open_.push({Estimate(start_), frame_.Index(start_)});
    const int goal = frame_.Index(goal_);
    while (!open_.empty()) {
      const auto [total, index] = open_.top();
      open_.pop();
      if (index == goal) return best_[goal];
      const Cell cell = frame_.CellOf(index);
      if (total > best_[index] + Estimate(cell) + 1e-4F) continue;  // an older, dearer entry
      Expand(cell, index);
    }
    return best_[goal];
  }

  /// The cells of the way, from start to goal.
  std::vector<Cell> Way() const {
    std::vector<Cell> way;
    for (int i = frame_.Index(goal_); i >= 0; i = from_[i]) way.push_back(frame_.CellOf(i));
    std::reverse(way.begin(), way.end());
    return way;
  }

 private:
  struct Entry {
    float total;
    int index;
    bool operator<(const Entry& other) const {
      return total != other.total ? total > other.total : index > other.index;
    }
  };

  /// The cost that is certainly left: the octile distance at the lowest cost, 1 per metre.
  float Estimate(Cell cell) const {
    const int dx = std::abs(cell.x - goal_.x);
    const int dy = std::abs(cell.y - goal_.y);
    const double cells = std::max(dx, dy) + (kDiagonal - 1) * std::min(dx, dy);
    return static_cast<float>(cells * frame_.resolution);
  }

  void Expand(Cell cell, int index) {
    for (int i = 0; i < 8; ++i) {
      const Cell step = kAround[i];
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (costmap_.Lethal(next)) continue;
      const bool diagonal = i >= 4;
      if (diagonal &&
          (costmap_.Lethal(Cell{next.x, cell.y}) || costmap_.Lethal(Cell{cell.x, next.y}))) {
        continue;
      }
      const int to = frame_.Index(next);
      const double length = (diagonal ? kDiagonal : 1) * frame_.resolution;
      const auto cost = static_cast<float>(
          best_[index] + length * 0.5 * (costmap_.cost(index) + costmap_.cost(to)));
      if (cost >= best_[to]) continue;
      best_[to] = cost;
      from_[to] = index;
      open_.push({cost + Estimate(next), to});
    }
  }

  const Costmap& costmap_;
  const GridFrame& frame_;
  Cell start_;
  Cell goal_;
  std::vector<float> best_;
  std::vector<int> from_;
  std::priority_queue<Entry> open_;
};

/// Cost of a straight line, or infinity if it touches a lethal cell.
double LineCost(const Costmap& costmap, Point2D a, Point2D b) {
  double sum = 0;
  int cells = 0;
  const bool free = TraceLine(costmap.frame(), a, b, [&](Cell cell) {
    if (costmap.Lethal(cell)) return false;
    sum += costmap.cost(costmap.frame().Index(cell));
    ++cells;
    return true;
  });
  return free ? Distance(a, b) * sum / cells : std::numeric_limits<double>::infinity();
}

void AppendLine(Point2D to, double spacing, std::vector<Point2D>& path) {
  const Point2D from = path.back();
  const int pieces = std::max(1, static_cast<int>(std::lround(Distance(from, to) / spacing)));
  for (int i = 1; i <= pieces; ++i) {
    const double part = static_cast<double>(i) / pieces;
    path.push_back({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
  }
}

}  // namespace

Plan FindPath(const Costmap& costmap, Point2D start, Point2D goal, double leave_radius) {
  const GridFrame& frame = costmap.frame();
  const Cell goal_cell = frame.CellAt(goal.x, goal.y);
  if (costmap.Lethal(goal_cell)) return GoalBlocked(costmap, goal);
  Plan plan;
  Cell start_cell = frame.CellAt(start.x, start.y);
  const bool start_lethal = costmap.Lethal(start_cell);
  if (start_lethal) {
    const auto free = NearestFree(costmap, start, leave_radius);
    if (!free) {
      plan.status = PlanStatus::kStartBlocked;
      plan.message = Print("the robot at (%.2f, %.2f) stands in an obstacle", start.x, start.y);
      return plan;
    }
    start_cell = *free;
  }
  Search search(costmap, start_cell, goal_cell);
  const double cost = search.Run();
  if (!std::isfinite(cost)) {
    plan.message = Print("no way to (%.2f, %.2f) is free", goal.x, goal.y);
    return plan;
  }
  plan.status = PlanStatus::kOk;
  plan.cost = cost;
  for (const Cell cell : search.Way()) plan.points.push_back(frame.Center(cell));
  // The true ends lie in the end cells, so the way stays in the same cells.
  if (start_lethal) {
    plan.points.insert(plan.points.begin(), start);
  } else {
    plan.points.front() = start;
  }
  if (plan.points.size() == 1) plan.points.push_back(goal);
  plan.points.back() = goal;
  return plan;
}

std::vector<Point2D> SmoothPath(const Costmap& costmap, const std::vector<Point2D>& path,
                                double spacing) {
  if (path.size() < 2) return path;
  std::vector<double> along{0};  // cost of the original way up to each point
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step = LineCost(costmap, path[i - 1], path[i]);
    // A start in lethal cells is left by the given first step, whatever it costs.
    along.push_back(along.back() + (std::isfinite(step) ? step : 1e6));
  }
  std::vector<Point2D> smooth{path.front()};
  for (std::size_t from = 0; from + 1 < path.size();) {
    std::size_t to = from + 1;
    constexpr double kSlack = 1.005;  // the two ways of summing up costs differ a little
    while (to + 1 < path.size() && to - from < kLongestLine &&
           LineCost(costmap, path[from], path[to + 1]) <= kSlack * (along[to + 1] - along[from])) {
      ++to;
    }
    AppendLine(path[to], spacing, smooth);
    from = to;
  }
  return smooth;
}

bool PathIsFree(const Costmap& costmap, const std::vector<Point2D>& path, double skip) {
  double gone = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double before = gone;
    gone += Distance(path[i - 1], path[i]);
    if (before < skip) continue;
    if (!TraceLine(costmap.frame(), path[i - 1], path[i],
                   [&](Cell cell) { return !costmap.Lethal(cell); })) {
      return false;
    }
  }
  return true;
}

double PathLength(const std::vector<Point2D>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += Distance(path[i - 1], path[i]);
  return length;
}

}  // namespace coppice::robot::navigation
