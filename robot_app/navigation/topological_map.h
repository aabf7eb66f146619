// The topological map: named places on the floor, and how to get from one to the next.
//
//   waypoints:
//     - {name: hall, x: 46, y: 0, yaw: 0, tolerance: 0.3, category: patrol}
//     - {name: charging_station, x: -0.8, y: 0, yaw: 3.1416, category: station}
//   edges:
//     - {from: hall, to: charging_station, action: navigate, both_ways: true}
//
// Positions are in the map frame [m, rad]. The idea of edges with actions is that of the STRANDS
// project (N. Hawes et al.: The STRANDS Project, IEEE Robotics & Automation Magazine 24 (2017)).
#ifndef COPPICE_ROBOT_APP_NAVIGATION_TOPOLOGICAL_MAP_H_
#define COPPICE_ROBOT_APP_NAVIGATION_TOPOLOGICAL_MAP_H_

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::navigation {

struct Place {
  std::string name;
  Pose2D pose;
  double tolerance = 0.3;  ///< near enough to count as being there [m]
  std::string category;    ///< "patrol", "station", "office", ...
};

enum class EdgeAction : std::uint8_t { kNavigate, kDock, kUndock };

struct Edge {
  int from = 0;  ///< indices of places
  int to = 0;
  EdgeAction action = EdgeAction::kNavigate;
};

class TopologicalMap {
 public:
  /// Reads a file. Every problem is added to `diagnostics` with file and line; nothing is returned
  /// if there was an error.
  static std::optional<TopologicalMap> Load(const std::string& path, Diagnostics& diagnostics);

  const std::vector<Place>& places() const { return places_; }
  const std::vector<Edge>& edges() const { return edges_; }
  std::vector<std::string> Names() const;

  /// Index of the place of that name, or -1.
  int Find(const std::string& name) const;

  /// Index of the place that is nearest to the pose as the crow flies.
  int Nearest(const Pose2D& pose) const;

  /// A random place of the category, all with the same chance, but not `last` unless it is the only
  /// one. -1 if the category has none. The same generator state gives the same choice everywhere.
  int ChooseNext(std::mt19937& random, int last, const std::string& category = "patrol") const;

  /// The edges of the shortest way between two places, as indices; nothing if there is no way.
  std::optional<std::vector<int>> Route(int from, int to) const;

 private:
  std::vector<Place> places_;
  std::vector<Edge> edges_;
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_TOPOLOGICAL_MAP_H_
