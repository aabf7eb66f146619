// The cheapest way along the edges of a topological map.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_ROUTE_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_ROUTE_H_

#include <optional>
#include <vector>

#include "robot_app/common/places/topological_map.h"

namespace coppice::robot {

/// Where a way may begin, and what it costs to get there [s].
struct RouteStart {
  int place = 0;
  double cost = 0;
};

struct Route {
  int start = 0;           ///< the place where it begins
  std::vector<int> edges;  ///< from there, in order; empty: it ends there
  double cost = 0;         ///< with that of the start [s]
};

/// `costs`: of each edge of the map [s], not negative. Nothing if no edges lead there. The first of
/// several that cost the same.
std::optional<Route> FindRoute(const TopologicalMap& map, const std::vector<RouteStart>& starts,
                               int to, const std::vector<double>& costs);

/// What an edge costs before anybody has travelled it [s]: its length at a walking pace of 0.5 m/s,
/// and time to dock, to undock, to wait for a door, to take the stairs.
std::vector<double> ExpectedCosts(const TopologicalMap& map);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_ROUTE_H_
