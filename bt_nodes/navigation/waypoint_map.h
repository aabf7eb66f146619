// What leaves need to know of the topological map. Called on the ticking thread.
#ifndef COPPICE_BT_NODES_NAVIGATION_WAYPOINT_MAP_H_
#define COPPICE_BT_NODES_NAVIGATION_WAYPOINT_MAP_H_

#include <string>

#include "bt_nodes/navigation/pose2d.h"

namespace coppice::leaves {

/// A named place of the topological map.
struct Waypoint {
  std::string name;
  Pose2D pose;
};

class WaypointMap {
 public:
  virtual ~WaypointMap() = default;
  /// A random waypoint of the patrol, another one than the last time.
  virtual Waypoint ChooseForPatrol() = 0;
  /// False if there is no waypoint of that name.
  virtual bool Find(const std::string& name, Waypoint& waypoint) const = 0;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_NAVIGATION_WAYPOINT_MAP_H_
