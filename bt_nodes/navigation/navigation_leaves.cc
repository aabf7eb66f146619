#include "bt_nodes/navigation/navigation_leaves.h"

namespace coppice::leaves {

Status ChooseWaypoint::Run() {
  const Waypoint chosen = map_.ChooseForPatrol();
  waypoint.Set(chosen.name);
  goal.Set(chosen.pose);
  return Status::kSuccess;
}

Status FindWaypoint::Run() {
  Waypoint found;
  if (!map_.Find(*waypoint, found)) return Fail("no waypoint \"" + *waypoint + "\" on the map");
  goal.Set(found.pose);
  return Status::kSuccess;
}

}  // namespace coppice::leaves
