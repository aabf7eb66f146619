// Maps in files, as map_server and its saver of ROS read and write them: a YAML file that says
// where the map lies, and a picture (PGM) of it. http://wiki.ros.org/map_server
//
// The picture has a name of its own for each content (map-5e2f81c0.pgm), and the YAML file, which
// names it, is replaced last and at once. So whoever reads NAME.yaml finds the old map or the new
// one, whole, also after a power failure; never the picture of one with the place of the other.
#ifndef COPPICE_ROBOT_APP_MAPPING_MAP_FILE_H_
#define COPPICE_ROBOT_APP_MAPPING_MAP_FILE_H_

#include <optional>
#include <string>

#include "bt_core/base/diagnostic.h"
#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::mapping {

/// Writes `yaml` and its picture, in a folder that is there, and removes the picture of the map
/// that was there before. Cells become occupied, free or unknown. False, with the reason, if that
/// fails; then the old map is as it was.
bool SaveMap(const std::string& yaml, const OccupancyGrid& map, Diagnostics& diagnostics);

/// Reads what SaveMap or map_server's saver has written (mode trinary). Whatever is wrong with
/// either file is in `diagnostics`, all at once, and there is no map then.
std::optional<OccupancyGrid> LoadMap(const std::string& yaml, Diagnostics& diagnostics);

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_MAP_FILE_H_
