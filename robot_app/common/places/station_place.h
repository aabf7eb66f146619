// The charging station of a site, and where the robot ends its work. Both are said in one file,
// places.yaml, by the categories of its places (topological_map.h): "station", and at a site
// without one "meeting_point", where people bring the robot and pick it up.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_STATION_PLACE_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_STATION_PLACE_H_

#include <optional>
#include <string>

#include "bt_core/base/diagnostic.h"
#include "robot_app/common/places/topological_map.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot {

/// base_link when docked, in the map frame; nothing if the site has no station. What is wrong with
/// the file is added to `diagnostics`.
std::optional<Pose2D> StationIn(const std::string& places_file, Diagnostics& diagnostics);

/// Index of the station, else of the meeting point, else -1.
int HomeOn(const TopologicalMap& map);

/// The same, its pose in the map frame. What is wrong with the file is added to `diagnostics`.
std::optional<Pose2D> HomeIn(const std::string& places_file, Diagnostics& diagnostics);

/// Sets `station` for a program whose parameter ~places may be "none"; then, and if the site has
/// none, it stays as it is. False, having told stderr why, if the file cannot be read.
bool ReadStation(const std::string& places_file, std::optional<Pose2D>& station);

/// The same with the home.
bool ReadHome(const std::string& places_file, std::optional<Pose2D>& home);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_STATION_PLACE_H_
