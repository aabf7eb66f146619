// The charging station of a site. Where it stands is said in one file, places.yaml: by the place of
// the category "station" (topological_map.h).
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_STATION_PLACE_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_STATION_PLACE_H_

#include <optional>
#include <string>

#include "bt_core/base/diagnostic.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot {

/// base_link when docked, in the map frame; nothing if the site has no station. What is wrong with
/// the file is added to `diagnostics`.
std::optional<Pose2D> StationIn(const std::string& places_file, Diagnostics& diagnostics);

/// Sets `station` for a program whose parameter ~places may be "none"; then, and if the site has
/// none, it stays as it is. False, having told stderr why, if the file cannot be read.
bool ReadStation(const std::string& places_file, std::optional<Pose2D>& station);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_STATION_PLACE_H_
