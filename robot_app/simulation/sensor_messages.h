// What the world's sensors measure as ROS sends it. Headers are left to the caller, but for the
// frame.
#ifndef COPPICE_ROBOT_APP_SIMULATION_SENSOR_MESSAGES_H_
#define COPPICE_ROBOT_APP_SIMULATION_SENSOR_MESSAGES_H_

#include <coppice_msgs/SimulatedWorld.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/Range.h>
#include <tf2_msgs/TFMessage.h>

#include "robot_app/common/robot_description.h"
#include "robot_app/simulation/grid_map.h"
#include "robot_app/simulation/world.h"

namespace coppice::robot::simulation {

geometry_msgs::Pose ToPoseMessage(const Pose2& pose);
geometry_msgs::TransformStamped ToTransform(const ros::Time& stamp, const char* parent,
                                            const char* child, const Pose2& pose);

/// The frames that are fixed on the robot. Those that move are told by who moves them.
tf2_msgs::TFMessage ToMessage(const RobotDescription& robot, const ros::Time& stamp);

nav_msgs::OccupancyGrid ToMessage(const GridMap& map);
nav_msgs::Odometry ToMessage(const Odometry& odometry);
sensor_msgs::LaserScan ToMessage(const Scan& scan, const LidarOptions& lidar);
/// Its frame is left to the caller too.
sensor_msgs::Range ToMessage(float range, const SonarOptions& sonar);
sensor_msgs::Imu ToMessage(const ImuReading& reading);
sensor_msgs::BatteryState ToMessage(const Battery& battery, bool docked);

/// But for the cameras.
coppice_msgs::SimulatedWorld ToMessage(const World& world);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SENSOR_MESSAGES_H_
