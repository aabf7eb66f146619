#include "robot_app/common/places/route.h"

#include <algorithm>
#include <limits>

namespace coppice::robot {
namespace {

constexpr double kPace = 0.5;  // m/s

double Extra(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::kDrive:
      return 0;
    case EdgeKind::kDoor:
      return 10;
    case EdgeKind::kDock:
      return 40;
    case EdgeKind::kUndock:
      return 20;
    case EdgeKind::kElsewhere:
      return 120;
  }
  return 0;
}

}  // namespace

std::optional<Route> FindRoute(const TopologicalMap& map, const std::vector<RouteStart>& starts,
                               int to, const std::vector<double>& costs) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const std::vector<Edge>& edges = map.edges();
  std::vector<double> best(map.places().size(), kFar);
  std::vector<int> by(map.places().size(), -1);  // the edge that leads here; -1: a start
  for (const RouteStart& start : starts) {
    double& cost = best[static_cast<std::size_t>(start.place)];
    cost = std::min(cost, start.cost);
  }
  // Bellman-Ford: maps have a few dozen edges.
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double cost = best[static_cast<std::size_t>(edges[i].from)] + costs[i];
      if (cost >= best[static_cast<std::size_t>(edges[i].to)]) continue;
      best[static_cast<std::size_t>(edges[i].to)] = cost;
      by[static_cast<std::size_t>(edges[i].to)] = static_cast<int>(i);
      shorter = true;
    }
  }
  Route route{to, {}, best[static_cast<std::size_t>(to)]};
  if (route.cost == kFar) return std::nullopt;
  while (by[static_cast<std::size_t>(route.start)] >= 0) {
    route.edges.push_back(by[static_cast<std::size_t>(route.start)]);
    route.start = edges[static_cast<std::size_t>(route.edges.back())].from;
  }
  std::reverse(route.edges.begin(), route.edges.end());
  return route;
}

std::vector<double> ExpectedCosts(const TopologicalMap& map) {
  std::vector<double> costs;
  for (const Edge& edge : map.edges()) {
    const auto& from = map.places()[static_cast<std::size_t>(edge.from)].pose;
    const auto& to = map.places()[static_cast<std::size_t>(edge.to)].pose;
    const double length = from && to ? Distance(*from, *to) : 0;
    costs.push_back(length / kPace + Extra(edge.kind));
  }
  return costs;
}

}  // namespace coppice::robot
