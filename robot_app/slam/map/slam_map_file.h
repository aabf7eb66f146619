// Maps of many sessions in files: a folder with a file for each version, map-000001.slam and so on.
//
// A version is written beside the others, synced and renamed, so that a crash while it is saved
// loses nothing; the three newest stay. It is compressed and checksummed (zstd); a damaged one is
// said, and the one before it is read.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAP_FILE_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAP_FILE_H_

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/base/outcome.h"
#include "robot_app/slam/map/slam_map.h"

namespace coppice::robot::slam {

struct LoadedMap {
  SlamMap map;
  int version = 0;
  std::string remark;  ///< what was wrong with newer versions; empty: nothing
};

/// What a key frame saw, packed (map_bytes.h).
using PackedKeyFrames = std::function<Expected<std::string>(std::uint32_t)>;

/// Writes the next version into `folder`, which is made if it is not there; returns its number.
/// Key frames that the map does not have in memory are asked of `others`.
Expected<int> SaveSlamMap(const std::string& folder, const SlamMap& map,
                          const PackedKeyFrames& others = {});

/// The number of the newest version in it, whole or not; 0: there is none.
int NewestVersion(const std::string& folder);

/// Reads the newest version that is whole.
Expected<LoadedMap> LoadSlamMap(const std::string& folder);

/// The same of one file, whatever its name.
Expected<SlamMap> ReadSlamMap(const std::string& file);

/// What is in a file, unpacked; nothing if the bytes are no map. Takes any bytes.
std::optional<SlamMap> ParseSlamMap(std::string_view bytes);
std::string BytesOf(const SlamMap& map);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAP_FILE_H_
