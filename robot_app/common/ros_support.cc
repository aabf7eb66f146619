#include "robot_app/common/ros_support.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <iostream>

#include "robot_app/common/find_master.h"
#include "robot_app/common/transforms/message_time.h"

namespace coppice::robot {
namespace {

constexpr float kFinest = 0.001F;  // m, of the cells of a map
constexpr float kCoarsest = 10;

constexpr char kFooter[] =
    "Ends on SIGTERM and SIGINT. Exit status 2: no ROS master answers, or a parameter is wrong.\n";

// Of this node, at the parameter server. Prints what is wrong; true if nothing is.
bool ReadParametersOfNode(const Parameters& parameters, const std::string& program) {
  XmlRpc::XmlRpcValue given;
  ros::param::get(ros::this_node::getName(), given);
  const auto problems = ReadParameters(parameters, given);
  for (const std::string& problem : problems) std::cerr << program << ": " << problem << '\n';
  return problems.empty();
}

}  // namespace

std::optional<int> StartNode(int argc, char** argv, const std::string& name,
                             const std::string& help, const Parameters& parameters) {
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler);  // takes out remappings
  std::string program = "coppice-" + name;
  std::replace(program.begin(), program.end(), '_', '-');
  if (argc > 1) {
    if (std::string(argv[1]) == "--help") {
      std::cout << help;
      if (!parameters.empty()) {
        std::cout << "  parameters, with default, range and meaning:\n" << Explain(parameters);
      }
      std::cout << kFooter;
      return 0;
    }
    std::cerr << program << ": unknown argument " << argv[1] << "; see --help\n";
    return 2;
  }
  const auto stop = [](int) { ros::requestShutdown(); };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  if (!FindMaster(program)) return 2;
  if (!ReadParametersOfNode(parameters, program)) return 2;
  return std::nullopt;
}

Parameters WithFrames(Parameters parameters, Frames& frames) {
  parameters.insert(parameters.end(), {{"map_frame", &frames.map, "the frame of the map"},
                                       {"odom_frame", &frames.odom, "of the odometry"},
                                       {"base_frame", &frames.base, "of the robot"}});
  return parameters;
}

double YawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

geometry_msgs::Twist ToTwist(const Velocity2D& velocity) {
  geometry_msgs::Twist twist;
  twist.linear.x = velocity.linear;
  twist.angular.z = velocity.angular;
  return twist;
}

Pose2D ToPose2D(const geometry_msgs::Pose& pose) {
  return {pose.position.x, pose.position.y, YawOf(pose.orientation)};
}

geometry_msgs::Pose ToPoseMessage(const Pose2D& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(pose.yaw / 2);
  message.orientation.w = std::cos(pose.yaw / 2);
  return message;
}

bool IsValid(const geometry_msgs::Pose& pose) {
  const geometry_msgs::Quaternion& q = pose.orientation;
  const double norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  return std::isfinite(pose.position.x) && std::isfinite(pose.position.y) &&
         std::abs(norm - 1) < 0.01;  // false for NaN
}

LaserScan ToLaserScan(const sensor_msgs::LaserScan& message, const Pose2D& mount) {
  LaserScan scan;
  scan.stamp = message.header.stamp.toSec();
  scan.mount = mount;
  scan.angle_min = message.angle_min;
  scan.angle_increment = message.angle_increment;
  scan.range_min = message.range_min;
  scan.range_max = std::min<double>(message.range_max, kFarthestRange);  // stays NaN
  scan.ranges = message.ranges;
  return scan;
}

RangeReading ToRangeReading(const sensor_msgs::Range& message, const Pose2D& mount) {
  RangeReading reading;
  reading.stamp = message.header.stamp.toSec();
  reading.mount = mount;
  reading.field_of_view = message.field_of_view;
  reading.min_range = message.min_range;
  reading.max_range = message.max_range;
  reading.range = message.range;
  return reading;
}

Expected<OccupancyGrid> ToGrid(const nav_msgs::OccupancyGrid& message) {
  OccupancyGrid grid;
  const auto& info = message.info;
  grid.frame = {info.resolution, info.origin.position.x, info.origin.position.y,
                static_cast<int>(info.width), static_cast<int>(info.height)};
  const bool has_size = info.resolution >= kFinest && info.resolution <= kCoarsest;
  if (!has_size || !std::isfinite(grid.frame.origin_x) || !std::isfinite(grid.frame.origin_y)) {
    return Problem{"the map's cells are not of 1 mm to 10 m, or it has no place"};
  }
  if (message.data.empty() ||
      message.data.size() != static_cast<std::size_t>(info.width) * info.height) {
    return Problem{"the map has not width * height cells"};
  }
  if (!(std::abs(YawOf(info.origin.orientation)) <= 1e-6)) {
    return Problem{"the map is rotated against its frame"};
  }
  grid.cells = message.data;
  return WithRoom(std::move(grid));
}

std::optional<RobotPose::Transform> RobotPose::Lookup(const std::string& target,
                                                      const std::string& source,
                                                      const ros::Time& stamp) const {
  const auto found = transforms_.Find(target, source, stamp);
  if (!found) return std::nullopt;  // not there yet, or not at that time
  const auto& t = found->transform;
  return Transform{{t.translation.x, t.translation.y, YawOf(t.rotation)},
                   found->header.stamp.toSec()};
}

std::optional<RobotPose::Stamped> RobotPose::Newest() const {
  const auto localization = Lookup(frames_.map, frames_.odom, ros::Time(0));
  const auto odometry = Lookup(frames_.odom, frames_.base, ros::Time(0));
  if (!localization || !odometry) return std::nullopt;
  return Stamped{Compose(localization->pose, odometry->pose),
                 std::min(localization->stamp, odometry->stamp)};
}

std::optional<Pose2D> RobotPose::At(const ros::Time& stamp) const {
  // The robot moves by odometry; localization only shifts that a little, so its newest will do.
  const auto localization = Lookup(frames_.map, frames_.odom, ros::Time(0));
  auto odometry = Lookup(frames_.odom, frames_.base, stamp);
  if (!odometry) odometry = Lookup(frames_.odom, frames_.base, ros::Time(0));
  if (!localization || !odometry) return std::nullopt;
  return Compose(localization->pose, odometry->pose);
}

std::optional<RobotPose::Stamped> RobotPose::InOdometry(const ros::Time& stamp) const {
  auto odometry = Lookup(frames_.odom, frames_.base, stamp);
  if (!odometry) odometry = Lookup(frames_.odom, frames_.base, ros::Time(0));
  if (!odometry) return std::nullopt;
  return Stamped{odometry->pose, odometry->stamp};
}

std::optional<RobotPose::Stamped> RobotPose::OdometryInMap() const {
  const auto localization = Lookup(frames_.map, frames_.odom, ros::Time(0));
  if (!localization) return std::nullopt;
  return Stamped{localization->pose, localization->stamp};
}

std::optional<Pose2D> RobotPose::MountOf(const std::string& frame) const {
  const auto mount = Lookup(frames_.base, frame, ros::Time(0));
  if (!mount) return std::nullopt;
  return mount->pose;
}

std::optional<LaserScan> RobotPose::UsableScan(const sensor_msgs::LaserScan& message) const {
  const auto stamp = StampOfNow(message.header, "/scan");
  if (!stamp) return std::nullopt;
  if (message.ranges.size() > kMostBeams) {  // not even to be copied
    ROS_WARN_THROTTLE(10, "a scan is not used: it has %zu beams", message.ranges.size());
    return std::nullopt;
  }
  const auto mount = MountOf(message.header.frame_id);
  if (!mount) {
    ROS_WARN_THROTTLE(10, "tf does not know where %s is", message.header.frame_id.c_str());
    return std::nullopt;
  }
  LaserScan scan = ToLaserScan(message, *mount);
  scan.stamp = *stamp;
  if (IsUsable(scan)) return scan;
  ROS_WARN_THROTTLE(10, "a scan is not used: %s", WhatTells(scan).c_str());
  return std::nullopt;
}

std::optional<Pose2D> RobotPose::InMap(const geometry_msgs::PoseStamped& pose) const {
  if (pose.header.frame_id == frames_.map) return ToPose2D(pose.pose);
  const auto frame = Lookup(frames_.map, pose.header.frame_id, ros::Time(0));
  if (!frame) return std::nullopt;
  return Compose(frame->pose, ToPose2D(pose.pose));
}

}  // namespace coppice::robot
