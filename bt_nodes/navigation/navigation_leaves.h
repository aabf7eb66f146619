// Leaves that move the robot: NavigateTo, LimitSpeed, BackUp, Rotate, and those that choose where
// to go.
#ifndef COPPICE_BT_NODES_NAVIGATION_NAVIGATION_LEAVES_H_
#define COPPICE_BT_NODES_NAVIGATION_NAVIGATION_LEAVES_H_

#include <string>

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/navigation/navigator.h"
#include "bt_nodes/navigation/waypoint_map.h"

namespace coppice::leaves {

class NavigateTo : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Drives to a pose on the map, around obstacles.";
  explicit NavigateTo(Navigator& navigator) : navigator_(navigator) {}
  Input<Pose2D> goal{this, "goal", "where to, in the map frame [m; m; rad]"};

 protected:
  void Begin(Sender<ActionResult> done) override { navigator_.NavigateTo(*goal, done); }
  void Cancel() override { navigator_.CancelNavigation(); }
  Turn* turn() override { return &navigator_.driving; }

 private:
  Navigator& navigator_;
};

class LimitSpeed : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Lets the robot drive to poses no faster than that for the next two seconds. Tick it again as "
      "long as it is to hold.";
  explicit LimitSpeed(Navigator& navigator) : navigator_(navigator) {}
  Input<double> speed{this, "speed", "at most [m/s], positive"};
  Status Run() override {
    navigator_.LimitSpeed(*speed);
    return Status::kSuccess;
  }

 private:
  Navigator& navigator_;
};

class BackUp : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Drives straight backwards for a short distance.";
  explicit BackUp(Navigator& navigator) : navigator_(navigator) {}
  Input<double> distance{this, "distance", "how far [m], positive", 0.3};
  Input<double> speed{this, "speed", "how fast [m/s], positive", 0.1};

 protected:
  void Begin(Sender<ActionResult> done) override { navigator_.Move(-*distance, *speed, done); }
  void Cancel() override { navigator_.CancelMotion(); }
  Turn* turn() override { return &navigator_.moving; }

 private:
  Navigator& navigator_;
};

class Rotate : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Turns on the spot.";
  explicit Rotate(Navigator& navigator) : navigator_(navigator) {}
  Input<double> angle{this, "angle", "how far [rad], counter-clockwise; a full turn is 6.2832"};
  Input<double> speed{this, "speed", "how fast [rad/s], positive", 0.4};

 protected:
  void Begin(Sender<ActionResult> done) override { navigator_.Rotate(*angle, *speed, done); }
  void Cancel() override { navigator_.CancelMotion(); }
  Turn* turn() override { return &navigator_.moving; }

 private:
  Navigator& navigator_;
};

class ChooseWaypoint : public SyncAction {
 public:
  static constexpr const char* kDescription = "Chooses a random place of the patrol.";
  explicit ChooseWaypoint(WaypointMap& map) : map_(map) {}
  Output<std::string> waypoint{this, "waypoint", "its name"};
  Output<Pose2D> goal{this, "goal", "where it is, in the map frame"};
  Status Run() override;

 private:
  WaypointMap& map_;
};

class FindWaypoint : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Looks up a place by its name; fails if there is none.";
  explicit FindWaypoint(WaypointMap& map) : map_(map) {}
  Input<std::string> waypoint{this, "waypoint", "name of the place"};
  Output<Pose2D> goal{this, "goal", "where it is, in the map frame"};
  Status Run() override;

 private:
  WaypointMap& map_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_NAVIGATION_NAVIGATION_LEAVES_H_
