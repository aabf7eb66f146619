// Follows a path and keeps off what the laser sees.
//
// S. Macenski, S. Singh, F. Martin, J. Gines: Regulated Pure Pursuit for Robot Path Tracking,
// Autonomous Robots 47 (2023): steers along the arc through a carrot on the path, slower in bends,
// near obstacles and before the goal, and not at all where the arc ends in an obstacle. The robot
// is a disc, so it may always turn on the spot: towards the path at the start, to the goal's
// heading at the end. No clock of its own: the caller says how much time has passed.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_FOLLOWER_H_
#define COPPICE_ROBOT_APP_NAVIGATION_FOLLOWER_H_

#include <cmath>
#include <vector>

#include "robot_app/common/footprint.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::navigation {

struct FollowerSettings {
  double max_speed = 0.7;              ///< [m/s]
  double min_speed = 0.05;             ///< slowest approach [m/s]
  double max_turn = 1.0;               ///< [rad/s]
  double acceleration = 0.5;           ///< [m/s^2]
  double deceleration = 0.6;           ///< [m/s^2]
  double turn_acceleration = 1.2;      ///< [rad/s^2]
  double lookahead_time = 1.0;         ///< distance to the carrot: speed times this [s]
  double min_lookahead = 0.35;         ///< [m]
  double max_lookahead = 0.8;          ///< [m]
  double turn_first_above = 0.8;       ///< turns on the spot if the path starts so far aside [rad]
  double bend_radius = 0.9;            ///< slower in bends tighter than this [m]
  double robot_radius = kRobotRadius;  ///< [m]
  double obstacle_margin = 0.02;       ///< kept free around the robot while it drives [m]
  double slow_within = 0.6;            ///< slower if something is nearer than this to the rim [m]
  double slow_to = 0.2;                ///< ... but never below this for nearness alone [m/s]
  double stop_distance = 0.1;          ///< stands still this far before an obstacle [m]
  double time_to_collision = 1.0;      ///< never nearer in time to an obstacle [s]
  double goal_tolerance = 0.15;        ///< [m]
  double goal_yaw_tolerance = 0.15;    ///< [rad]
};

/// How far the disc of `radius` can drive along the arc of `curvature` [1/m] before it touches one
/// of the `obstacles` (in base_link), at most `limit` [m]. Negative `limit` looks backwards. Points
/// that the disc touches already count only if it would come nearer to them.
double FreeDistance(const std::vector<Point2D>& obstacles, double curvature, double radius,
                    double limit);

class Follower {
 public:
  struct Command {
    Velocity2D velocity;
    bool obstacle = false;  ///< held by an obstacle ahead
    bool reached = false;   ///< at the goal, turned and at rest
  };

  explicit Follower(FollowerSettings settings = {}) : settings_(settings) {}

  /// Takes a new path (at least one point, map frame). Speed and phase are kept, so that a path may
  /// be replaced while driving; call ClearPath() before the first one of a new goal.
  void SetPath(std::vector<Point2D> path, double goal_yaw);
  /// Forgets the path; the speed is kept. For a new goal while driving.
  void ClearPath();
  /// Forgets the path and that the robot has been moving.
  void Reset();

  /// From now on at most `speed` [m/s] along paths, whatever the settings allow beyond.
  void LimitSpeed(double speed) { speed_limit_ = speed; }

  /// The next command, `seconds` after the last one. `obstacles` are the laser's points in
  /// base_link. Without a path: braking.
  Command Update(const Pose2D& pose, const std::vector<Point2D>& obstacles, double seconds);

  /// Slows down to a stop; to be called instead of Update().
  Velocity2D Brake(double seconds);

  /// Turns towards `angle` to go [rad], within the limits; to be called instead of Update().
  Velocity2D Turn(double angle, double seconds);

  /// True once the goal's position is reached and only turning is left.
  bool at_goal() const { return at_goal_; }
  const std::vector<Point2D>& path() const { return path_; }
  /// Distance from the path at the last update [m].
  double tracking_error() const { return tracking_error_; }

 private:
  void FindNearest(const Pose2D& pose);
  Point2D Carrot(double lookahead) const;
  double RemainingLength(const Pose2D& pose) const;
  void UpdateAtGoal(const Pose2D& pose);
  double SpeedLimit(const Pose2D& pose, const std::vector<Point2D>& obstacles,
                    double curvature) const;
  Command TurnToGoal(const Pose2D& pose, double seconds);

  FollowerSettings settings_;
  double speed_limit_ = HUGE_VAL;
  std::vector<Point2D> path_;
  double goal_yaw_ = 0;
  std::size_t nearest_ = 0;  // index of the nearest path point
  bool turning_ = false;     // on the spot, towards the path
  bool at_goal_ = false;
  double tracking_error_ = 0;
  Velocity2D velocity_;  // the last command
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_FOLLOWER_H_
