// What the ROS programs of navigation and docking have in common: the start, parameters, messages
// turned into plain values, and the robot's pose from tf. For the thread that spins.
#ifndef COPPICE_ROBOT_APP_COMMON_ROS_SUPPORT_H_
#define COPPICE_ROBOT_APP_COMMON_ROS_SUPPORT_H_

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot {

/// Starts the ROS node `name`; SIGTERM and SIGINT will end ros::spin. Prints `help` for --help, one
/// line for an unknown argument or if no master answers. Nothing: go on; else the exit status.
std::optional<int> StartNode(int argc, char** argv, const std::string& name,
                             const std::string& help);

/// Private parameters (~name) with bounds. Problems are collected and printed by Finish(), also
/// parameters that nobody asked for.
class Parameters {
 public:
  double Number(const std::string& name, double otherwise, double low, double high);
  std::string Text(const std::string& name, const std::string& otherwise);
  /// Prints the problems, one line each; false if there was one.
  bool Finish();

 private:
  std::vector<std::string> asked_;
  std::vector<std::string> problems_;
};

/// Names of the frames in which the robot is described.
struct Frames {
  std::string map;
  std::string odom;
  std::string base;
};
/// From ~map_frame (map), ~odom_frame (odom), ~base_frame (base_link).
Frames ReadFrames(Parameters& parameters);

double YawOf(const geometry_msgs::Quaternion& rotation);
geometry_msgs::Twist ToTwist(const Velocity2D& velocity);
Pose2D ToPose2D(const geometry_msgs::Pose& pose);
geometry_msgs::Pose ToPoseMessage(const Pose2D& pose);

/// False if the rotation is no unit quaternion, or a number is not finite.
bool IsValid(const geometry_msgs::Pose& pose);

LaserScan ToLaserScan(const sensor_msgs::LaserScan& message, const Pose2D& mount);

/// Nothing, with the reason, if the grid is rotated or has not width * height cells.
std::optional<OccupancyGrid> ToGrid(const nav_msgs::OccupancyGrid& message, std::string& error);

/// Where the robot is, from tf.
class RobotPose {
 public:
  struct Stamped {
    Pose2D pose;       ///< base_link in the map frame
    double stamp = 0;  ///< of the older one of localization and odometry [s]
  };

  explicit RobotPose(Frames frames) : frames_(std::move(frames)) {}

  /// The newest pose; nothing before tf is complete. Odometry and localization are looked up each
  /// at its newest, so that a slow localization does not make the pose old.
  std::optional<Stamped> Newest() const;
  /// The pose at a time, or the newest one if tf does not have that time.
  std::optional<Pose2D> At(const ros::Time& stamp) const;
  /// The fixed place of a sensor's frame in base_link; nothing if tf does not know it.
  std::optional<Pose2D> MountOf(const std::string& frame) const;
  /// A scan with the place of its scanner. Nothing, with a warning now and then, if tf does not
  /// know that place or the scan is not usable (laser_scan.h): for all who ask, silence.
  std::optional<LaserScan> UsableScan(const sensor_msgs::LaserScan& message) const;
  /// A pose given in any frame, in the map frame; nothing if tf cannot tell.
  std::optional<Pose2D> InMap(const geometry_msgs::PoseStamped& pose) const;

 private:
  struct Transform {
    Pose2D pose;
    double stamp = 0;
  };
  std::optional<Transform> Lookup(const std::string& target, const std::string& source,
                                  const ros::Time& stamp) const;

  const Frames frames_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_ROS_SUPPORT_H_
