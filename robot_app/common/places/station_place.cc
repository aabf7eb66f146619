#include "robot_app/common/places/station_place.h"

#include <cstdio>

#include "robot_app/common/places/topological_map.h"

namespace coppice::robot {

std::optional<Pose2D> StationIn(const std::string& places_file, Diagnostics& diagnostics) {
  const auto map = TopologicalMap::Load(places_file, diagnostics);
  const int station = map ? map->FirstOf("station") : -1;
  if (station < 0) return std::nullopt;
  return map->places()[static_cast<std::size_t>(station)].pose;
}

bool ReadStation(const std::string& places_file, std::optional<Pose2D>& station) {
  if (places_file == "none") return true;
  Diagnostics diagnostics;
  const auto found = StationIn(places_file, diagnostics);
  if (diagnostics.has_errors()) {
    std::fprintf(stderr, "%s", diagnostics.ToString().c_str());
    return false;
  }
  if (found) station = found;
  return true;
}

}  // namespace coppice::robot
