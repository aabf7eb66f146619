// Leads a robot through a topological map, a leg at a time, and learns from how the legs end.
//
// A leg is what one planner travels: edges that are driven one behind the other are one leg, so
// that nobody stops at each corner of a corridor; a door, the station and another floor are legs of
// their own. Nothing of the way is remembered between legs: each is worked out anew from where the
// robot is, so a robot that was led astray, restarted, or sent elsewhere in the middle is led on
// from there.
//
//   RouteGuide guide(map);
//   auto leg = guide.Next(pose, map.Find("office_103"), now);   // leg->goal, leg->kind
//   ... travel it ...
//   guide.Ended(leg->name, true, pose, seconds, now);
//
// All poses in the map frame. Not for several threads.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_ROUTE_GUIDE_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_ROUTE_GUIDE_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/places/edge_memory.h"
#include "robot_app/common/places/route.h"
#include "robot_app/common/places/topological_map.h"

namespace coppice::robot {

struct Leg {
  /// Its places, "hall -> corridor_east -> corridor_103"; begins with "-> " where the robot is on
  /// its way to the first place.
  std::string name;
  EdgeKind kind = EdgeKind::kDrive;  ///< never kElsewhere
  Pose2D goal;  ///< where it ends; looks where the way goes on, at its end as the place says
  int to = 0;   ///< the place where it ends
};

class RouteGuide {
 public:
  explicit RouteGuide(TopologicalMap map) : map_(std::move(map)), memory_(map_) {}

  const TopologicalMap& map() const { return map_; }
  const EdgeMemory& memory() const { return memory_; }
  EdgeMemory& memory() { return memory_; }

  /// The next leg of the way to a place; none if the robot is there, or where the rest of the way
  /// is elsewhere. A problem if no edges lead there.
  Expected<std::optional<Leg>> Next(const Pose2D& robot, int place, Time now) const;

  /// All of the way from the robot to a place; nothing if no edges lead there.
  std::optional<Route> Whole(const Pose2D& robot, int place, Time now) const {
    return Find(Entries(robot), place, now);
  }

  /// How a leg ended that took so many seconds, with the robot where it is now. A leg that was not
  /// travelled blocks the edge that the robot stands before.
  void Ended(const std::string& leg, bool travelled, const Pose2D& robot, double seconds, Time now);

  /// The place of the category with the shortest way from the robot. A problem if there is none.
  Expected<int> Nearest(const Pose2D& robot, const std::string& category, Time now) const;

  /// What people are told of that part of the way which is elsewhere; else empty.
  std::string Words(const Pose2D& robot, int place, const std::string& language, Time now) const;

 private:
  struct Entry {
    RouteStart start;
    int edge = -1;  // on which the robot is; -1: at the place, or beside all edges
  };

  std::vector<Entry> Entries(const Pose2D& robot) const;
  std::optional<Route> Find(const std::vector<Entry>& entries, int place, Time now) const;
  bool IsAt(const Pose2D& robot, int place) const;
  double DistanceTo(const Edge& edge, const Pose2D& robot) const;
  Pose2D GoalOf(const Route& route, std::size_t next) const;
  std::vector<int> EdgesOf(const std::string& leg, const Pose2D& robot, bool* whole) const;

  TopologicalMap map_;
  EdgeMemory memory_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_ROUTE_GUIDE_H_
