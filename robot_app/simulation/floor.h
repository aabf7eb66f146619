// The description of a floor of a building: what stands where before anything moves.
//
// 2.5-D: every thing is a vertical prism on the floor plane with a height, so that the lidar looks
// over what is low and a renderer can raise the walls. The frame is `map`. A floor is read from
// YAML; the shipped robot_app/config/sites/institute/world.yaml shows every key.
#ifndef COPPICE_ROBOT_APP_SIMULATION_FLOOR_H_
#define COPPICE_ROBOT_APP_SIMULATION_FLOOR_H_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/common/places/landmark_shape.h"
#include "robot_app/simulation/scene/geometry.h"

namespace coppice::robot::simulation {

/// A door leaf. Closed it fills hinge..end. Open, a hinged leaf stands turned by 90 degrees into
/// the room (to the left or right of hinge -> end) and a sliding leaf has gone into the wall.
struct Door {
  enum class Kind { kHinged, kSliding };
  std::string name;
  Kind kind = Kind::kHinged;
  Vec2 hinge;
  Vec2 end;
  bool swings_left = true;  ///< hinged only
  bool open = true;         ///< at the start
};

/// Furniture, or a place that can be blocked by a box of this shape.
struct FloorBox {
  std::string name;
  Rectangle shape;
  double height = 1;
  bool is_poster = false;  ///< many-coloured; as thin as paper if it hangs at a wall
};

/// A person who walks from point to point, and from the last one to the first.
struct Walker {
  std::string name;
  double speed = 1;  ///< m/s
  std::vector<Vec2> path;
  double height = 1.75;  ///< m
  bool mask = false;     ///< over mouth and nose
  /// Goes round a robot that stands in the way, if there is room; else only waits and turns round.
  bool steps_aside = false;
};

struct FloorWaypoint {
  std::string name;
  Pose2 pose;
};

/// The triangle of a charging station; see landmark_shape.h.
struct StationLandmark {
  LandmarkShape shape;
  double height = 0.5;
};

struct Floor {
  std::string name;
  double wall_height = 2.5;
  bool sky = false;          ///< no ceiling; the sun's infrared blinds depth cameras
  double light = 1;          ///< for cameras: 1 in the sun or with all lamps on, 0.02 nearly dark
  std::vector<Vec2> ground;  ///< see scene/ground.h; empty: level
  double resolution = 0.05;  ///< of its map [m]
  std::vector<std::vector<Vec2>> walls;  ///< polylines
  /// The same of glass: light goes through, so that lidars, cameras and the map do not have them.
  std::vector<std::vector<Vec2>> glass;
  std::vector<FloorBox> furniture;
  std::vector<Door> doors;
  std::vector<FloorBox> places;  ///< that can be blocked; empty at the start
  std::vector<Walker> people;
  std::vector<FloorWaypoint> waypoints;  ///< good goals for the robot
  /// A floor says where either the station or the start is.
  bool has_station = true;
  Pose2 docked;  ///< base_link when the charging contacts touch; without a station: where it begins
  Pose2 staging;                            ///< base_link in front of the station, ready to dock
  std::optional<StationLandmark> landmark;  ///< of the station; absent: it is invisible
};

/// Reads a floor. Adds every problem found, with file and line, and then returns nothing. Never
/// throws.
std::optional<Floor> LoadFloor(const std::string& file, Diagnostics& diagnostics);

/// The same from text; `file` is only the name in the messages.
std::optional<Floor> ParseFloor(const std::string& yaml, const std::string& file,
                                Diagnostics& diagnostics);

/// Where the leaf of a door stands. A sliding door that is open has none.
std::optional<Segment> DoorLeaf(const Door& door, bool open);

/// Where the landmark stands when the contacts are at `docked`: its corner, and the ends of its
/// left and right leg as seen by a docked robot.
using Triangle = std::array<Vec2, 3>;
Triangle LandmarkAt(const LandmarkShape& shape, const Pose2& docked);

/// Its three sides.
std::array<Segment, 3> SidesOf(const Triangle& triangle);

/// The distance of a point from the area that the leaf passes when the door opens or closes; 0
/// inside it.
double DistanceFromSweep(const Door& door, Vec2 point);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_FLOOR_H_
