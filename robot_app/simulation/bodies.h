// Motion and collisions of the solid things of a floor, by Box2D 2.4.
//
// Walls, furniture, doors and boxes stand still, people move and nothing stops them, the robot is a
// disc of 150 kg that is stopped by all of them. Box2D's continuous collision keeps it from passing
// through anything, however long the time step. Not thread-safe.
#ifndef COPPICE_ROBOT_APP_SIMULATION_BODIES_H_
#define COPPICE_ROBOT_APP_SIMULATION_BODIES_H_

#include <memory>
#include <optional>
#include <vector>

#include "robot_app/common/footprint.h"
#include "robot_app/simulation/drive.h"
#include "robot_app/simulation/floor.h"
#include "robot_app/simulation/scene/ray_caster.h"

namespace coppice::robot::simulation {

inline constexpr double kRobotMass = 150;  ///< kg

class Bodies {
 public:
  /// Walls and furniture of the floor, and the robot, a disc of `radius` metres, at `start` (map
  /// frame). Doors, boxes and
  /// people follow by the calls below.
  Bodies(const Floor& floor, const Pose2& start, double radius = kRobotRadius);
  ~Bodies();
  Bodies(const Bodies&) = delete;
  Bodies& operator=(const Bodies&) = delete;

  /// Puts the leaf of door `i` somewhere, or takes it away.
  void SetDoor(std::size_t i, const std::optional<Segment>& leaf);

  /// Puts the box of place `i` there, or takes it away.
  void SetPlace(std::size_t i, const std::optional<Rectangle>& box);

  /// Puts the landmark of the charging station there, or takes it away.
  void SetLandmark(const std::optional<Triangle>& landmark);

  /// Moves person `i` to `disc` in the next Step().
  void SetPerson(std::size_t i, const Disc& disc, double dt);

  /// Lifts the robot and puts it down at `pose` (map frame), standing.
  void PutRobot(const Pose2& pose);

  /// Lets `dt` seconds pass. The wheels try to hold `velocity`; what stands in the way may take it
  /// away.
  void Step(double dt, const Velocity& velocity);

  Pose2 robot() const;        ///< base_link in the map frame
  Velocity velocity() const;  ///< what the robot really did in the last step
  bool touching() const;      ///< the robot touches something

 private:
  struct Box2D;
  std::unique_ptr<Box2D> box2d_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_BODIES_H_
