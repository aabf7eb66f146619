// A short motion relative to where the robot stands: straight on, then a turn on the spot.
//
// Forwards it stops before what the laser sees. Backwards nothing looks, so the way is limited to
// kLongestBackwards, and a robot whose odometry stands still although it should move is taken to
// have touched something. Deterministic, without a clock; poses are those of odometry.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_RELATIVE_MOTION_H_
#define COPPICE_ROBOT_APP_NAVIGATION_RELATIVE_MOTION_H_

#include <string>
#include <vector>

#include "robot_app/common/footprint.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot::navigation {

struct RelativeMotionSettings {
  double longest_backwards = 1.0;      ///< [m]
  double default_speed = 0.15;         ///< [m/s]
  double default_turn = 0.5;           ///< [rad/s]
  double max_speed = 0.5;              ///< [m/s]
  double max_turn = 1.0;               ///< [rad/s]
  double acceleration = 0.4;           ///< [m/s^2]
  double deceleration = 0.6;           ///< of what the robot did before [m/s^2]
  double turn_acceleration = 1.0;      ///< [rad/s^2]
  double robot_radius = kRobotRadius;  ///< [m]
  double stop_distance = 0.1;          ///< kept from obstacles in front [m]
  double obstacle_patience = 3.0;      ///< waits this long for an obstacle to go [s]
  double stall_time = 1.0;             ///< [s] ...
  double stall_share = 0.2;            ///< ... with less than this share of the commanded way
};

class RelativeMotion {
 public:
  enum class State : std::uint8_t { kIdle, kMoving, kDone, kFailed };

  explicit RelativeMotion(RelativeMotionSettings settings = {}) : settings_(settings) {}

  /// Starts from odometry pose `from`. `distance` [m], negative: backwards; `angle` [rad], done
  /// after the distance; `speed` [m/s or rad/s] > 0, or 0 for the default. A request that is not
  /// allowed leads to kFailed with the reason in message(). A robot that is still moving with
  /// `velocity` is stopped first; the motion counts from where it then stands.
  void Start(const Pose2D& from, double distance, double angle, double speed,
             const Velocity2D& velocity = {});

  /// The next command, `seconds` after the last one. `obstacles`: laser points in base_link. Fails
  /// where the odometry jumps: the way that is left would be measured from anywhere.
  Velocity2D Update(const Pose2D& odometry, const std::vector<Point2D>& obstacles, double seconds);

  State state() const { return state_; }
  /// True while it drives forwards, so that it needs a laser scan that is not too old.
  bool looks_ahead() const { return state_ == State::kMoving && straight_ && distance_ > 0; }
  /// Why it failed, or that it is done.
  const std::string& message() const { return message_; }
  /// What is left of the distance [m], or after it of the angle [rad].
  double remaining() const { return remaining_; }

 private:
  Velocity2D Fail(std::string message);
  Velocity2D Stop(const Pose2D& odometry, double seconds);
  Velocity2D Straight(const Pose2D& odometry, const std::vector<Point2D>& obstacles,
                      double seconds);
  Velocity2D Turn(const Pose2D& odometry, double seconds);
  bool Stalled(double moved, double commanded, double seconds);
  bool HeldTooLong(const std::vector<Point2D>& obstacles, double seconds, double& speed);

  RelativeMotionSettings settings_;
  State state_ = State::kIdle;
  std::string message_;
  double distance_ = 0;
  double angle_ = 0;
  double speed_ = 0;
  bool stopping_ = false;  // what the robot did before
  bool straight_ = false;  // the distance is not done yet
  Pose2D from_;
  Pose2D last_;        // odometry of the last update
  double turned_ = 0;  // since the distance was done [rad]
  double remaining_ = 0;
  double held_ = 0;           // by an obstacle [s]
  double stall_seconds_ = 0;  // window of the stall detection
  double stall_moved_ = 0;
  double stall_commanded_ = 0;
  Velocity2D velocity_;
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_RELATIVE_MOTION_H_
