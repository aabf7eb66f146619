// What the docking leaves need of a robot. Implemented on the action server "docking" in
// robot_app/ros, and on test doubles.
//
// All functions are called on the ticking thread and return at once. The end is reported through
// the sender, from any thread.
#ifndef COPPICE_BT_NODES_DOCKING_CHARGING_STATION_H_
#define COPPICE_BT_NODES_DOCKING_CHARGING_STATION_H_

#include "bt_core/data/inbox.h"
#include "bt_nodes/basics/action_result.h"
#include "bt_nodes/basics/turn.h"

namespace coppice::leaves {

class ChargingStation {
 public:
  virtual ~ChargingStation() = default;
  /// Drives onto the station from the pose in front of it, `lateral_offset` [m] to the left of its
  /// axis. Succeeds only when current flows; fails after so many `attempts`.
  virtual void Dock(double lateral_offset, int attempts, Sender<ActionResult> done) = 0;
  /// Stands on the station without current: presses on and draws back a little until it flows.
  virtual void PressOn(Sender<ActionResult> done) = 0;
  /// Drives off the station backwards.
  virtual void Undock(Sender<ActionResult> done) = 0;
  virtual void CancelDocking() = 0;

  Turn turn;  ///< of all its actions
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_DOCKING_CHARGING_STATION_H_
