// Drives the robot to a goal: plans, follows, waits for obstacles to go, recovers, gives up.
//
// A deterministic state machine without a clock, a thread or ROS: the same inputs give the same
// commands. It replans every second, and waits `patience` when an obstacle or the lack of a path
// holds the robot. After that come two recoveries of its own, like those of move_base: forget all
// obstacles that the laser does not see right now, then turn once on the spot to look around. When
// they do not help either, the goal is aborted with the reason. Not thread-safe.
//
//   Navigation navigation(settings);
//   navigation.SetMap(grid);
//   navigation.SetGoal(goal, now);
//   at 10 Hz:  navigation.AddScan(pose, scan);
//   and, with ultrasonic sensors:  navigation.AddRange(pose, reading, now);
//   at 20 Hz:  Velocity2D velocity = navigation.Update(now, pose, pose_stamp);
#ifndef COPPICE_ROBOT_APP_NAVIGATION_NAVIGATION_H_
#define COPPICE_ROBOT_APP_NAVIGATION_NAVIGATION_H_

#include <cstdint>
#include <optional>
#include <string>

#include "robot_app/navigation/follower.h"
#include "robot_app/navigation/obstacle_layer.h"
#include "robot_app/navigation/planner.h"
#include "robot_app/navigation/sonar_layer.h"

namespace coppice::robot::navigation {

struct NavigationSettings {
  FollowerSettings follower;
  CostSettings costs;
  ObstacleSettings obstacles;
  SonarSettings sonar;
  double replan_period = 1.0;     ///< [s]
  double blocked_after = 1.0;     ///< held by an obstacle for this long: blocked [s]
  double patience = 8.0;          ///< waits this long before recovering [s]
  double after_recovery = 2.0;    ///< waits this long for a recovery to help [s]
  double sensor_timeout = 1.0;    ///< older poses and scans are not driven with [s]
  double sensor_patience = 20.0;  ///< aborts the goal when they are missing for this long [s]
};

/// As in coppice_msgs/NavigationState, with the same values.
enum class NavigationStatus : std::uint8_t { kIdle, kDriving, kBlocked, kNoPath };

/// "idle", "driving", "blocked", "no path".
const char* ToString(NavigationStatus status);

class Navigation {
 public:
  /// How a goal ended; reported once by the Update() in which it did.
  enum class End : std::uint8_t { kNone, kReached, kAborted };

  explicit Navigation(NavigationSettings settings = {});

  /// The floor. Drops all obstacles seen so far. Goals are refused before there is a map.
  void SetMap(OccupancyGrid map);
  bool has_map() const { return !map_.cells.empty(); }

  /// Takes a goal in the map frame, replacing the one before.
  void SetGoal(const Pose2D& goal, double now);
  /// Drops the goal; following calls of Update() brake to a stop.
  void Cancel(double now);
  /// Something else has moved the robot: plan anew and start all waiting times again.
  void Restart(double now);

  /// From now on at most `speed` [m/s] on the way to goals.
  void LimitSpeed(double speed) { follower_.LimitSpeed(speed); }

  /// Enters a scan taken with base_link at `pose` in the map frame.
  void AddScan(const Pose2D& pose, const LaserScan& scan);

  /// Enters a reading of an ultrasonic sensor taken with base_link at `pose`, which comes at `now`.
  /// A problem says why it is refused (sonar_layer.h).
  Outcome AddRange(const Pose2D& pose, const RangeReading& reading, double now);

  /// Adds to `points` what the sonars have heard near the robot at `pose`, in base_link.
  void AddHeard(const Pose2D& pose, std::vector<Point2D>& points) const;

  /// The command for base_link from `now` [s] on. `pose` was true at `pose_stamp` [s]; -HUGE_VAL:
  /// there is none yet. Where `now` goes back all waiting times start again and what was seen is
  /// forgotten; the goal stays.
  Velocity2D Update(double now, const Pose2D& pose, double pose_stamp);

  /// The way from a pose to a point [m], around all obstacles that are known at `now`, for who
  /// wants to know it without driving there.
  Plan FindWay(const Pose2D& pose, Point2D goal, double now);

  /// How the goal ended in the last Update(), and why if it was aborted.
  End end() const { return end_; }
  const std::string& message() const { return message_; }

  NavigationStatus status() const { return status_; }
  double status_since() const { return status_since_; }
  bool has_goal() const { return goal_.has_value(); }
  /// Goals aborted since the last one that was reached.
  int consecutive_failures() const { return consecutive_failures_; }
  /// Changes with every new path; empty if there is none.
  const std::vector<Point2D>& path() const { return follower_.path(); }
  int path_number() const { return path_number_; }
  const Costmap& costmap() const { return costmap_; }
  const Follower& follower() const { return follower_; }

 private:
  enum class Recovery : std::uint8_t { kNone, kForgetObstacles, kTurn };

  void TimeWasSetBack(double now);
  void StartOver(double now);
  void SetStatus(NavigationStatus status, double now, std::string message);
  void Finish(End end, double now, std::string message);
  bool SensorsFresh(double now, double pose_stamp);
  void EnterObstacles(double now);
  void Replan(double now, const Pose2D& pose);
  Velocity2D Drive(double now, const Pose2D& pose, double seconds);
  Velocity2D TurnOnce(double now, const Pose2D& pose, double seconds);
  void NoteProgress(double now, const Pose2D& pose);
  bool OutOfPatience(double now) const;
  void Recover(double now, const Pose2D& pose);

  NavigationSettings settings_;
  OccupancyGrid map_;
  Costmap static_costs_;  // of the map alone
  Costmap costmap_;       // with obstacles
  ObstacleLayer obstacles_;
  SonarLayer sonar_;
  Follower follower_;
  std::vector<Point2D> points_;  // the newest scan, in base_link
  LaserScan scan_;
  Pose2D scan_pose_;
  std::vector<Point2D> seen_;  // the newest scan, in the map frame

  std::optional<Pose2D> goal_;
  NavigationStatus status_ = NavigationStatus::kIdle;
  double status_since_ = 0;
  std::string message_ = "no goal";
  End end_ = End::kNone;
  int consecutive_failures_ = 0;
  int path_number_ = 0;

  double last_update_ = -1;
  double next_plan_ = 0;
  double held_since_ = -1;               // by an obstacle; negative: not held
  double fresh_at_ = 0;                  // when pose and scan were last fresh
  Pose2D progress_pose_;                 // the robot has got here...
  double progress_at_ = 0;               // ... at this time
  Recovery recovery_ = Recovery::kNone;  // the last one tried at this place
  double turn_left_ = 0;                 // of the recovery turn [rad]; 0: not turning
  double last_yaw_ = 0;
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_NAVIGATION_H_
