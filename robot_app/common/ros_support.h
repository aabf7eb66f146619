// What the ROS programs of navigation and docking have in common: the start, messages turned into
// plain values, and the robot's pose from tf. For the thread that spins.
#ifndef COPPICE_ROBOT_APP_COMMON_ROS_SUPPORT_H_
#define COPPICE_ROBOT_APP_COMMON_ROS_SUPPORT_H_

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/Range.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/laser_scan.h"
#include "robot_app/common/occupancy_grid.h"
#include "robot_app/common/parameters.h"
#include "robot_app/common/range_reading.h"
#include "robot_app/common/transforms/transforms.h"

namespace coppice::robot {

/// Starts the ROS node of a program, coppice-a-node as /a_node for the name "a_node", and reads its
/// parameters; SIGTERM and SIGINT will end ros::spin. Prints `help` and the parameters for --help;
/// one line for an unknown argument, if no master answers, or for each wrong parameter. Nothing: go
/// on; else the exit status.
std::optional<int> StartNode(int argc, char** argv, const std::string& name,
                             const std::string& help, const Parameters& parameters = {});

/// What main of a program with parameters does: StartNode with what ParametersOf(settings) says of
/// its Settings, then `run(settings)` -> exit status. ROS lives until that returns.
template <class Settings, class Run>
int RunNode(int argc, char** argv, const std::string& name, const std::string& help, Run run) {
  Settings settings;
  const Parameters parameters = ParametersOf(settings);
  if (const auto status = StartNode(argc, argv, name, help, parameters)) return *status;
  const ros::NodeHandle keep_alive;
  return run(settings);
}

/// The same for a Node(settings) that does everything in callbacks.
template <class Node, class Settings>
int SpinNode(int argc, char** argv, const std::string& name, const std::string& help) {
  return RunNode<Settings>(argc, argv, name, help, [](const Settings& settings) {
    Node node(settings);
    ros::spin();
    return 0;
  });
}

/// Names of the frames in which the robot is described.
struct Frames {
  std::string map = "map";
  std::string odom = "odom";
  std::string base = "base_link";
};
/// The table, and behind it ~map_frame, ~odom_frame and ~base_frame.
Parameters WithFrames(Parameters parameters, Frames& frames);

double YawOf(const geometry_msgs::Quaternion& rotation);
geometry_msgs::Twist ToTwist(const Velocity2D& velocity);
Pose2D ToPose2D(const geometry_msgs::Pose& pose);
geometry_msgs::Pose ToPoseMessage(const Pose2D& pose);

/// False if the rotation is no unit quaternion, or a number is not finite.
bool IsValid(const geometry_msgs::Pose& pose);

LaserScan ToLaserScan(const sensor_msgs::LaserScan& message, const Pose2D& mount);
RangeReading ToRangeReading(const sensor_msgs::Range& message, const Pose2D& mount);

/// A problem if the grid is rotated, has not width * height cells, or its cells or its place are
/// none that a map can have, or there is no room for it (WithRoom).
Expected<OccupancyGrid> ToGrid(const nav_msgs::OccupancyGrid& message);

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
  /// base_link in the frame of the odometry, which never jumps: at a time, or the newest if tf does
  /// not have that time. Needs no localization.
  std::optional<Stamped> InOdometry(const ros::Time& stamp = ros::Time(0)) const;
  /// The frame of the odometry in the map, as the localization said last.
  std::optional<Stamped> OdometryInMap() const;
  /// The fixed place of a sensor's frame in base_link; nothing if tf does not know it.
  std::optional<Pose2D> MountOf(const std::string& frame) const;
  /// A scan with the place of its scanner. Nothing, with a warning now and then, if tf does not
  /// know that place, the scan is not of now (transforms/message_time.h) or not usable
  /// (laser_scan.h): for all who ask, silence.
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
  Transforms transforms_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_ROS_SUPPORT_H_
