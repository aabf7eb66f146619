// The folder of a map: its versions in files, and beside them what the program had when it ended.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_MAP_FOLDER_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_MAP_FOLDER_H_

#include <memory>
#include <string>

#include "robot_app/slam/map/map_store.h"

namespace coppice::robot::slam {

struct OpenedMap {
  std::unique_ptr<MapStore> store;
  SlamMap map;         ///< key frames that are in the store are null
  int version = 0;     ///< the newest one in the folder; 0: none
  std::string remark;  ///< why an older version was read; empty: it was not
};

/// The map that the store has, unless the folder has a version that was put there by somebody else.
/// "": a map that nobody sees and that vanishes with the program.
Expected<OpenedMap> OpenMapFolder(const std::string& folder);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_MAP_FOLDER_H_
