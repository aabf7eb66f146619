// Leaves that lead the robot along the ways of the topological map, and those that tell people of
// them: NextLeg, RememberLeg, IsAtPlace, NearestPlace, DescribePlace, WayIsFree.
//
// trees/behavior/go_to_place.xml puts them together.
#ifndef COPPICE_BT_NODES_NAVIGATION_ROUTE_LEAVES_H_
#define COPPICE_BT_NODES_NAVIGATION_ROUTE_LEAVES_H_

#include <string>

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/navigation/navigator.h"
#include "bt_nodes/navigation/routes.h"

namespace coppice::leaves {

class NextLeg : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Works out the next leg of the way to a place from where the robot is now; fails if it is "
      "there or no way leads there.";
  explicit NextLeg(Routes& routes) : routes_(routes) {}
  Input<std::string> place{this, "place", "name of the place"};
  Input<Pose2D> pose{this, "pose", "where the robot is, in the map frame"};
  Input<std::string> language{this, "language", "of spoken: en, de, ...", "en"};
  Output<std::string> leg{this, "leg", "its places, for RememberLeg"};
  Output<std::string> kind{this, "kind", "who travels it: drive, door, dock or undock"};
  Output<Pose2D> goal{this, "goal", "where it ends, in the map frame"};
  Output<std::string> spoken{this, "spoken", "what people call the place where it ends"};
  Status Run() override;

 private:
  Routes& routes_;
};

class RememberLeg : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Remembers how a leg ended: how long it took, or that it is blocked.";
  explicit RememberLeg(Routes& routes) : routes_(routes) {}
  Input<std::string> leg{this, "leg", "as NextLeg gave it"};
  Input<bool> travelled{this, "travelled", "did the robot get to its end?"};
  Input<Pose2D> pose{this, "pose", "where the robot is, in the map frame"};
  Status Run() override;

 private:
  Routes& routes_;
};

class IsAtPlace : public Condition {
 public:
  static constexpr const char* kDescription =
      "Is the robot at the place, or where people have to be told the rest of the way?";
  explicit IsAtPlace(Routes& routes) : routes_(routes) {}
  Input<std::string> place{this, "place", "name of the place"};
  Input<Pose2D> pose{this, "pose", "where the robot is, in the map frame"};
  bool Check() override;

 private:
  Routes& routes_;
};

class NearestPlace : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Finds the place of a category to which the way is shortest.";
  explicit NearestPlace(Routes& routes) : routes_(routes) {}
  Input<std::string> category{this, "category", "for example office"};
  Input<Pose2D> pose{this, "pose", "where the robot is, in the map frame"};
  Output<std::string> place{this, "place", "its name"};
  Status Run() override;

 private:
  Routes& routes_;
};

class DescribePlace : public SyncAction {
 public:
  static constexpr const char* kDescription = "What to say of a place and of the way to it.";
  explicit DescribePlace(Routes& routes) : routes_(routes) {}
  Input<std::string> place{this, "place", "name of the place"};
  Input<Pose2D> pose{this, "pose", "where the robot is, in the map frame"};
  Input<std::string> language{this, "language", "en, de, ...", "en"};
  Output<std::string> spoken{this, "spoken", "what people call it"};
  Output<std::string> words{this, "words",
                            "what they are told of the way that no robot travels; else empty"};
  Status Run() override;

 private:
  Routes& routes_;
};

class WayIsFree : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "Is there a way to the goal right now, around all that the robot sees? It does not move.";
  explicit WayIsFree(Navigator& navigator) : navigator_(navigator) {}
  Input<Pose2D> goal{this, "goal", "where to, in the map frame"};

 protected:
  void Begin(Sender<ActionResult> done) override { navigator_.FindWay(*goal, done); }
  void Cancel() override {}  // an answer that comes later is of no use

 private:
  Navigator& navigator_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_NAVIGATION_ROUTE_LEAVES_H_
