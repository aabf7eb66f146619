#include "robot_app/simulation/sensor_messages.h"

#include <cmath>
#include <limits>

namespace coppice::robot::simulation {
namespace {

geometry_msgs::Quaternion ToQuaternion(double yaw) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(yaw / 2);
  q.w = std::cos(yaw / 2);
  return q;
}

std::vector<std::uint8_t> ToBytes(const std::vector<bool>& flags) {
  return {flags.begin(), flags.end()};
}

}  // namespace

geometry_msgs::Pose ToPoseMessage(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation = ToQuaternion(pose.yaw);
  return message;
}

geometry_msgs::TransformStamped ToTransform(const ros::Time& stamp, const char* parent,
                                            const char* child, const Pose2& pose) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.x;
  transform.transform.translation.y = pose.y;
  transform.transform.rotation = ToQuaternion(pose.yaw);
  return transform;
}

tf2_msgs::TFMessage ToMessage(const RobotDescription& robot, const ros::Time& stamp) {
  tf2_msgs::TFMessage message;
  for (const FrameOnRobot& frame : robot.frames()) {
    if (!frame.is_fixed) continue;
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = stamp;
    transform.header.frame_id = frame.parent;
    transform.child_frame_id = frame.name;
    transform.transform.translation.x = frame.position[0];
    transform.transform.translation.y = frame.position[1];
    transform.transform.translation.z = frame.position[2];
    transform.transform.rotation.x = frame.rotation[0];
    transform.transform.rotation.y = frame.rotation[1];
    transform.transform.rotation.z = frame.rotation[2];
    transform.transform.rotation.w = frame.rotation[3];
    message.transforms.push_back(transform);
  }
  return message;
}

nav_msgs::OccupancyGrid ToMessage(const GridMap& map) {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = "map";
  message.info.resolution = static_cast<float>(map.resolution);
  message.info.width = static_cast<std::uint32_t>(map.width);
  message.info.height = static_cast<std::uint32_t>(map.height);
  message.info.origin = ToPoseMessage({map.origin.x, map.origin.y, 0});
  message.data = map.cells;
  return message;
}

nav_msgs::Odometry ToMessage(const Odometry& odometry) {
  nav_msgs::Odometry message;
  message.header.frame_id = "odom";
  message.child_frame_id = "base_link";
  message.pose.pose = ToPoseMessage(odometry.pose());
  message.twist.twist.linear.x = odometry.velocity().linear;
  message.twist.twist.angular.z = odometry.velocity().angular;
  return message;
}

sensor_msgs::LaserScan ToMessage(const Scan& scan, const LidarOptions& lidar) {
  sensor_msgs::LaserScan message;
  message.header.frame_id = "laser";
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_max = static_cast<float>(-scan.angle_min);
  message.angle_increment = static_cast<float>(scan.angle_step);
  message.scan_time = static_cast<float>(lidar.period);
  message.range_min = static_cast<float>(lidar.min_range);
  message.range_max = static_cast<float>(lidar.max_range);
  message.ranges = scan.ranges;
  return message;
}

sensor_msgs::Range ToMessage(float range, const SonarOptions& sonar) {
  sensor_msgs::Range message;
  message.radiation_type = sensor_msgs::Range::ULTRASOUND;
  message.field_of_view = static_cast<float>(sonar.field_of_view);
  message.min_range = static_cast<float>(sonar.min_range);
  message.max_range = static_cast<float>(sonar.max_range);
  message.range = range;
  return message;
}

sensor_msgs::Imu ToMessage(const ImuReading& reading) {
  sensor_msgs::Imu message;
  message.header.frame_id = "imu_link";
  message.orientation_covariance[0] = -1;  // not measured
  message.angular_velocity.z = reading.yaw_rate;
  message.linear_acceleration.x = reading.acceleration_x;
  message.linear_acceleration.y = reading.acceleration_y;
  message.linear_acceleration.z = reading.acceleration_z;
  for (int i = 0; i < 9; i += 4) {
    message.angular_velocity_covariance[i] = Imu::kYawRateNoise * Imu::kYawRateNoise;
    message.linear_acceleration_covariance[i] = Imu::kAccelerationNoise * Imu::kAccelerationNoise;
  }
  return message;
}

sensor_msgs::BatteryState ToMessage(const Battery& battery, bool docked) {
  using State = sensor_msgs::BatteryState;
  State message;
  message.voltage = static_cast<float>(battery.voltage());
  message.temperature = std::numeric_limits<float>::quiet_NaN();
  message.current = static_cast<float>(battery.current());
  message.charge = static_cast<float>(battery.charge());
  message.capacity = static_cast<float>(battery.capacity());
  message.design_capacity = message.capacity;
  message.percentage = static_cast<float>(battery.state_of_charge());
  message.power_supply_status = battery.charging() ? State::POWER_SUPPLY_STATUS_CHARGING
                                : !docked          ? State::POWER_SUPPLY_STATUS_DISCHARGING
                                : battery.full()   ? State::POWER_SUPPLY_STATUS_FULL
                                                   : State::POWER_SUPPLY_STATUS_NOT_CHARGING;
  message.power_supply_health = State::POWER_SUPPLY_HEALTH_GOOD;
  message.present = 1;
  return message;
}

coppice_msgs::SimulatedWorld ToMessage(const World& world) {
  coppice_msgs::SimulatedWorld message;
  message.header.frame_id = "map";
  message.robot.x = world.robot().x;
  message.robot.y = world.robot().y;
  message.robot.theta = world.robot().yaw;
  for (const Stance& stance : world.stances()) {
    coppice_msgs::SimulatedPerson person;
    person.x = stance.position.x;
    person.y = stance.position.y;
    person.heading = stance.heading;
    person.walked = stance.walked;
    person.walks = stance.walks;
    message.people.push_back(person);
  }
  message.door_open = ToBytes(world.door_open());
  message.place_blocked = ToBytes(world.place_blocked());
  message.station_moved.x = world.station_moved().x;
  message.station_moved.y = world.station_moved().y;
  message.station_moved.theta = world.station_moved().yaw;
  message.landmark = world.landmark().has_value();
  return message;
}

}  // namespace coppice::robot::simulation
