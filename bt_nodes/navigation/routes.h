// What leaves need of the ways between the places of a site. Implemented on the topological map in
// robot_app/common/places. All functions are called on the ticking thread and return at once.
#ifndef COPPICE_BT_NODES_NAVIGATION_ROUTES_H_
#define COPPICE_BT_NODES_NAVIGATION_ROUTES_H_

#include <optional>
#include <string>

#include "bt_core/base/outcome.h"
#include "bt_nodes/navigation/pose2d.h"

namespace coppice::leaves {

/// A stretch of a way that is travelled in one go.
struct RouteLeg {
  std::string name;    ///< its places, for Ended
  std::string kind;    ///< who travels it: "drive", "door", "dock" or "undock"
  Pose2D goal;         ///< where it ends, in the map frame
  std::string spoken;  ///< what people call the place where it ends
};

class Routes {
 public:
  virtual ~Routes() = default;

  /// The next leg of the way from the robot to a place, which it begins now, with names in a
  /// language ("en", "de"); none if it is there, or where people have to be told the rest. A
  /// problem if there is no such place, or no way to it.
  virtual Expected<std::optional<RouteLeg>> NextLeg(const Pose2D& robot, const std::string& place,
                                                    const std::string& language) = 0;
  /// Is no leg left of the way to a place? False if there is no such place, or no way to it.
  virtual bool IsAt(const Pose2D& robot, const std::string& place) = 0;
  /// How that leg ended, with the robot where it is now.
  virtual void Ended(const std::string& leg, bool travelled, const Pose2D& robot) = 0;

  /// The name of that place of the category which has the shortest way from the robot.
  virtual Expected<std::string> Nearest(const Pose2D& robot, const std::string& category) = 0;

  /// What people call a place, and what they are told of the part of the way that no robot travels
  /// (empty: the robot gets there), in a language.
  struct Description {
    std::string spoken;
    std::string words;
  };
  virtual Expected<Description> Describe(const Pose2D& robot, const std::string& place,
                                         const std::string& language) = 0;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_NAVIGATION_ROUTES_H_
