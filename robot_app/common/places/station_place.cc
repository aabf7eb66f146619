#include "robot_app/common/places/station_place.h"

#include <cstdio>

namespace coppice::robot {
namespace {

std::optional<Pose2D> PoseOf(const TopologicalMap& map, int place) {
  return place < 0 ? std::nullopt : map.places()[static_cast<std::size_t>(place)].pose;
}

// Sets `pose` by what is found in the file, unless that is "none".
template <class Find>
bool Read(const std::string& places_file, std::optional<Pose2D>& pose, Find find) {
  if (places_file == "none") return true;
  Diagnostics diagnostics;
  const std::optional<Pose2D> found = find(places_file, diagnostics);
  if (diagnostics.has_errors()) {
    std::fprintf(stderr, "%s", diagnostics.ToString().c_str());
    return false;
  }
  if (found) pose = found;
  return true;
}

}  // namespace

int HomeOn(const TopologicalMap& map) {
  const int station = map.FirstOf("station");
  return station >= 0 ? station : map.FirstOf("meeting_point");
}

std::optional<Pose2D> StationIn(const std::string& places_file, Diagnostics& diagnostics) {
  const auto map = TopologicalMap::Load(places_file, diagnostics);
  return map ? PoseOf(*map, map->FirstOf("station")) : std::nullopt;
}

std::optional<Pose2D> HomeIn(const std::string& places_file, Diagnostics& diagnostics) {
  const auto map = TopologicalMap::Load(places_file, diagnostics);
  return map ? PoseOf(*map, HomeOn(*map)) : std::nullopt;
}

bool ReadStation(const std::string& places_file, std::optional<Pose2D>& station) {
  return Read(places_file, station, &StationIn);
}

bool ReadHome(const std::string& places_file, std::optional<Pose2D>& home) {
  return Read(places_file, home, &HomeIn);
}

}  // namespace coppice::robot
