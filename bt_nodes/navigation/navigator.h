// What the navigation leaves need of a robot. Implemented on move_base and the motion server in
// robot_app/ros, on the simulated world and on test doubles.
//
// All functions are called on the ticking thread and return at once. The end of an action is
// reported through the sender, from any thread; a new action of the same kind replaces the one
// before it, whose sender is then not used.
#ifndef COPPICE_BT_NODES_NAVIGATION_NAVIGATOR_H_
#define COPPICE_BT_NODES_NAVIGATION_NAVIGATOR_H_

#include "bt_core/data/inbox.h"
#include "bt_nodes/basics/action_result.h"
#include "bt_nodes/basics/turn.h"
#include "bt_nodes/navigation/pose2d.h"

namespace coppice::leaves {

class Navigator {
 public:
  virtual ~Navigator() = default;

  /// Drives to a pose in the map frame, around obstacles.
  virtual void NavigateTo(const Pose2D& goal, Sender<ActionResult> done) = 0;
  virtual void CancelNavigation() = 0;
  /// For the next two seconds it drives to poses at `speed` [m/s] at most, positive.
  virtual void LimitSpeed(double speed) = 0;

  /// Is there a way to a pose in the map frame right now, around all that is seen? Nothing moves.
  virtual void FindWay(const Pose2D& goal, Sender<ActionResult> done) = 0;

  /// Drives straight on by `distance` [m] (negative: backwards) at `speed` [m/s] and stops before
  /// obstacles.
  virtual void Move(double distance, double speed, Sender<ActionResult> done) = 0;
  /// Turns on the spot by `angle` [rad], counter-clockwise, at `speed` [rad/s].
  virtual void Rotate(double angle, double speed, Sender<ActionResult> done) = 0;
  virtual void CancelMotion() = 0;

  Turn driving;  ///< of NavigateTo
  Turn moving;   ///< of Move and Rotate
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_NAVIGATION_NAVIGATOR_H_
