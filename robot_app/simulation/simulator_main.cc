// coppice-simulator: a World as the ROS node /simulator, until SIGTERM, SIGINT or a shutdown
// request by XML-RPC. Its topics, parameters and faults: --help.
#include <coppice_msgs/InjectFault.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <thread>

#include "robot_app/common/ros_support.h"
#include "robot_app/simulation/camera_node.h"
#include "robot_app/simulation/cloud_message.h"
#include "robot_app/simulation/faults.h"
#include "robot_app/simulation/grid_map.h"
#include "robot_app/simulation/node_signals.h"

namespace coppice::robot::simulation {
namespace {

constexpr char kHelp[] =
    "coppice-simulator: the simulated robot and its floor, as the ROS node /simulator.\n"
    "  subscribes  /cmd_vel\n"
    "  publishes   /clock /odom /scan /imu/data /battery_state /map /tf /tf_static\n"
    "              /emergency_stop (std_msgs/Bool, true while pressed)\n"
    "              /simulation/truth (for evaluation only)\n"
    "              /velodyne_points (the 3-D lidar, while somebody subscribes)\n"
    "              /camera/front/image/compressed, /camera/rear/image/compressed (while watched)\n"
    "  service     /simulation/inject_fault (coppice_msgs/InjectFault: breaks things)\n";

constexpr double kStep = 0.02;       // s of simulated time
constexpr double kStartTime = 1000;  // s; so that "ten seconds ago" exists for everybody
constexpr char kInstitute[] = "institute";

geometry_msgs::Quaternion ToQuaternion(double yaw) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(yaw / 2);
  q.w = std::cos(yaw / 2);
  return q;
}

geometry_msgs::Pose ToPose(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation = ToQuaternion(pose.yaw);
  return message;
}

geometry_msgs::TransformStamped ToTransform(ros::Time stamp, const char* parent, const char* child,
                                            const Pose2& pose, double z = 0) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = pose.x;
  message.transform.translation.y = pose.y;
  message.transform.translation.z = z;
  message.transform.rotation = ToQuaternion(pose.yaw);
  return message;
}

// In whole microseconds: the world's time is a sum of steps, and 0.8 s should not read 0.799999999.
ros::Time ToRosTime(double time) {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(std::llround((kStartTime + time) * 1e6)) * 1000);
  return stamp;
}

struct Settings {
  std::string floor_file = kInstitute;
  std::optional<Pose2D> start;
  double speed = 1;
  bool localization = true;
  bool odometry_tf = true;
  WorldOptions world;
  Floor floor;
};

Parameters ParametersOf(Settings& settings) {
  WorldOptions& world = settings.world;
  return {
      {"floor", &settings.floor_file, "description of the floor, a YAML file"},
      {"seed", &world.seed, 0, 1e9, "of the sensors' noise"},
      {"speed", &settings.speed, 0, 1000, "times real time; 0: as fast as possible"},
      {"start", &settings.start, "\"X Y YAW\" on the map; none: docked"},
      {"state_of_charge", &world.state_of_charge, 0, 1, "of the battery"},
      {"localization", &settings.localization, "publishes map -> odom"},
      {"odometry_tf", &settings.odometry_tf, "publishes odom -> base_link"},
  };
}

// Says once for each `period` of simulated time that something is due.
class Every {
 public:
  explicit Every(double period) : period_(period) {}
  bool Due(double time) {
    if (time + 1e-9 < next_) return false;
    next_ = std::max(next_ + period_, time - period_);
    return true;
  }

 private:
  double period_;
  double next_ = 0;
};

class SimulatorNode {
 public:
  explicit SimulatorNode(const Settings& settings)
      : settings_(settings),
        world_(settings.floor, settings.world),
        node_signals_(ros::master::getURI(), ros::this_node::getName(), ros::network::getHost()),
        faults_(world_,
                {"/odom", "/scan", "/velodyne_points", "/imu/data", "/battery_state",
                 "/emergency_stop", "/tf", "/simulation/truth"},
                [this](const std::string& node, int signal) {
                  return node_signals_.Send(node, signal);
                }) {
    Advertise();
    PublishMap();
    PublishMounting();
  }

  void Run() {
    using Clock = std::chrono::steady_clock;
    auto next = Clock::now();
    while (ros::ok()) {
      ros::getGlobalCallbackQueue()->callAvailable();
      Step();
      if (settings_.speed <= 0) continue;
      next += std::chrono::duration_cast<Clock::duration>(
          std::chrono::duration<double>(kStep / settings_.speed));
      // Too slow a computer slows the simulated time down; it does not catch up in a burst.
      next = std::max(next, Clock::now() - std::chrono::milliseconds(200));
      std::this_thread::sleep_until(next);
    }
  }

 private:
  void Advertise() {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    odom_ = node_.advertise<nav_msgs::Odometry>("/odom", 20);
    scan_ = node_.advertise<sensor_msgs::LaserScan>("/scan", 10);
    cloud_ = node_.advertise<sensor_msgs::PointCloud2>("/velodyne_points", 5);
    imu_ = node_.advertise<sensor_msgs::Imu>("/imu/data", 50);
    battery_ = node_.advertise<sensor_msgs::BatteryState>("/battery_state", 5);
    map_ = node_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 50);
    tf_static_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    stop_ = node_.advertise<std_msgs::Bool>("/emergency_stop", 5, true);
    truth_ = node_.advertise<geometry_msgs::PoseStamped>("/simulation/truth", 5);
    command_subscriber_ = node_.subscribe<geometry_msgs::Twist>(
        "/cmd_vel", 1, [this](const geometry_msgs::Twist::ConstPtr& twist) {
          command_ = Velocity{twist->linear.x, twist->angular.z};
        });
    using Service = coppice_msgs::InjectFault;
    fault_service_ = node_.advertiseService(
        "/simulation/inject_fault",
        boost::function<bool(Service::Request&, Service::Response&)>(
            [this](Service::Request& request, Service::Response& response) {
              const Change outcome =
                  faults_.Inject({request.fault, request.target, request.value, request.duration});
              response.ok = outcome.ok();
              response.message = outcome ? *outcome : outcome.problem();
              ROS_INFO("%s %s: %s", request.fault.c_str(), request.target.c_str(),
                       response.message.c_str());
              return true;
            }));
  }

  void Step() {
    world_.SetLidar3dOn(cloud_.getNumSubscribers() > 0 &&
                        std::chrono::steady_clock::now() >= lidar_rests_until_);
    world_.Step(kStep, command_);
    command_.reset();
    faults_.Update();
    stamp_ = ToRosTime(world_.time());
    rosgraph_msgs::Clock clock;
    clock.clock = stamp_;
    clock_.publish(clock);
    PublishMotion();
    PublishScan();
    PublishCloud();
    PublishImu();
    if (battery_due_.Due(world_.time())) PublishBattery();
    PublishEmergencyStop();
    if (truth_due_.Due(world_.time())) PublishTruth();
    cameras_.Publish(world_, stamp_);
  }

  template <typename Message>
  void Publish(const ros::Publisher& publisher, const Message& message) {
    for (int copies = faults_.Copies(publisher.getTopic()); copies > 0; --copies) {
      publisher.publish(message);
    }
  }

  void PublishMotion() {
    const Odometry& odometry = world_.odometry();
    if (odometry.time() == odometry_time_) return;
    odometry_time_ = odometry.time();
    nav_msgs::Odometry odom;
    odom.header.stamp = stamp_;
    odom.header.frame_id = "odom";
    odom.child_frame_id = "base_link";
    odom.pose.pose = ToPose(odometry.pose());
    odom.twist.twist.linear.x = odometry.velocity().linear;
    odom.twist.twist.angular.z = odometry.velocity().angular;
    Publish(odom_, odom);
    tf2_msgs::TFMessage tf;
    if (settings_.odometry_tf) {
      tf.transforms.push_back(ToTransform(stamp_, "odom", "base_link", odometry.pose()));
    }
    if (settings_.localization && localization_due_.Due(world_.time())) {
      tf.transforms.push_back(ToTransform(stamp_, "map", "odom", world_.OdomInMap()));
    }
    if (!tf.transforms.empty()) Publish(tf_, tf);
  }

  void PublishScan() {
    const Scan& scan = world_.scan();
    if (scan.time == scan_time_) return;
    scan_time_ = scan.time;
    const LidarOptions& lidar = world_.lidar().options();
    sensor_msgs::LaserScan message;
    message.header.stamp = stamp_;
    message.header.frame_id = "laser";
    message.angle_min = static_cast<float>(scan.angle_min);
    message.angle_max = static_cast<float>(-scan.angle_min);
    message.angle_increment = static_cast<float>(scan.angle_step);
    message.scan_time = static_cast<float>(lidar.period);
    message.range_min = static_cast<float>(lidar.min_range);
    message.range_max = static_cast<float>(lidar.max_range);
    message.ranges = scan.ranges;
    Publish(scan_, message);
  }

  // Between two turns. Faster than real time the 3-D lidar and who looks at its clouds would take
  // more of the computer than all else; so it turns as often in a second of wall time as a real
  // one.
  std::chrono::nanoseconds LidarRest() const {
    const double period = world_.lidar_3d().options().period;
    const double turn = settings_.speed > 0 ? period / settings_.speed : 0;
    return std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * std::max(0.0, period - turn)));
  }

  void PublishCloud() {
    const Cloud& cloud = world_.lidar_3d().cloud();
    if (cloud.points.empty() || cloud.time == cloud_time_) return;
    cloud_time_ = cloud.time;
    lidar_rests_until_ = std::chrono::steady_clock::now() + LidarRest();
    sensor_msgs::PointCloud2 message = ToMessage(cloud, world_.lidar_3d().options().rings);
    message.header.stamp = ToRosTime(cloud.time);
    message.header.frame_id = "velodyne";
    Publish(cloud_, message);
  }

  void PublishImu() {
    const ImuReading& reading = world_.imu();
    sensor_msgs::Imu message;
    message.header.stamp = stamp_;
    message.header.frame_id = "base_link";
    message.orientation_covariance[0] = -1;  // not measured
    message.angular_velocity.z = reading.yaw_rate;
    message.linear_acceleration.x = reading.acceleration_x;
    message.linear_acceleration.y = reading.acceleration_y;
    message.linear_acceleration.z = reading.acceleration_z;
    for (int i = 0; i < 9; i += 4) {
      message.angular_velocity_covariance[i] = Imu::kYawRateNoise * Imu::kYawRateNoise;
      message.linear_acceleration_covariance[i] = Imu::kAccelerationNoise * Imu::kAccelerationNoise;
    }
    Publish(imu_, message);
  }

  sensor_msgs::BatteryState MeasureBattery() const {
    using State = sensor_msgs::BatteryState;
    const Battery& battery = world_.battery();
    State message;
    message.voltage = static_cast<float>(battery.voltage());
    message.temperature = std::numeric_limits<float>::quiet_NaN();
    message.current = static_cast<float>(battery.current());
    message.charge = static_cast<float>(battery.charge());
    message.capacity = static_cast<float>(battery.capacity());
    message.design_capacity = message.capacity;
    message.percentage = static_cast<float>(battery.state_of_charge());
    message.power_supply_status = battery.charging() ? State::POWER_SUPPLY_STATUS_CHARGING
                                  : !world_.docked() ? State::POWER_SUPPLY_STATUS_DISCHARGING
                                  : battery.full()   ? State::POWER_SUPPLY_STATUS_FULL
                                                     : State::POWER_SUPPLY_STATUS_NOT_CHARGING;
    message.power_supply_health = State::POWER_SUPPLY_HEALTH_GOOD;
    message.present = 1;
    return message;
  }

  void PublishBattery() {
    if (!faults_.battery_frozen()) battery_state_ = MeasureBattery();
    battery_state_.header.stamp = stamp_;
    Publish(battery_, battery_state_);
  }

  void PublishEmergencyStop() {
    if (!stop_due_.Due(world_.time()) && emergency_stop_ == world_.emergency_stop()) return;
    emergency_stop_ = world_.emergency_stop();
    std_msgs::Bool message;
    message.data = emergency_stop_;
    Publish(stop_, message);
  }

  void PublishTruth() {
    geometry_msgs::PoseStamped message;
    message.header.stamp = stamp_;
    message.header.frame_id = "map";
    message.pose = ToPose(world_.robot());
    Publish(truth_, message);
  }

  void PublishMap() {
    const GridMap map = MakeGridMap(settings_.floor);
    nav_msgs::OccupancyGrid message;
    message.header.stamp = ToRosTime(0);
    message.header.frame_id = "map";
    message.info.map_load_time = message.header.stamp;
    message.info.resolution = static_cast<float>(map.resolution);
    message.info.width = map.width;
    message.info.height = map.height;
    message.info.origin = ToPose({map.origin.x, map.origin.y, 0});
    message.data = map.cells;
    map_.publish(message);
  }

  void PublishMounting() {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(ToTransform(ToRosTime(0), "base_link", "laser",
                                             world_.lidar().options().mounting, kLidarHeight));
    const Lidar3dOptions& lidar_3d = world_.lidar_3d().options();
    message.transforms.push_back(
        ToTransform(ToRosTime(0), "base_link", "velodyne", lidar_3d.mounting, lidar_3d.height));
    tf_static_.publish(message);
  }

  Settings settings_;
  World world_;
  NodeSignals node_signals_;
  Faults faults_;
  ros::NodeHandle node_;
  CameraNode cameras_{node_};
  ros::Publisher clock_, odom_, scan_, cloud_, imu_, battery_, map_, tf_, tf_static_, stop_, truth_;
  ros::Subscriber command_subscriber_;
  ros::ServiceServer fault_service_;
  std::optional<Velocity> command_;
  ros::Time stamp_;
  sensor_msgs::BatteryState battery_state_;
  bool emergency_stop_ = false;
  double odometry_time_ = -1;
  double scan_time_ = -1;
  double cloud_time_ = -1;
  std::chrono::steady_clock::time_point lidar_rests_until_{};
  Every localization_due_{0.1};
  Every battery_due_{0.5};
  Every stop_due_{0.5};
  Every truth_due_{0.2};
};

// What follows from the parameters. False, having said why, if the floor cannot be read.
bool Derive(Settings& settings) {
  if (settings.start) {
    settings.world.start = Pose2{settings.start->x, settings.start->y, settings.start->yaw};
  }
  const bool is_shipped = settings.floor_file == kInstitute;
  Diagnostics diagnostics;
  const auto floor = LoadFloor(is_shipped ? COPPICE_FLOOR : settings.floor_file, diagnostics);
  if (floor) {
    settings.floor = *floor;
  } else {
    std::fprintf(stderr, "coppice-simulator: %s\n", ToString(diagnostics.all().front()).c_str());
  }
  return floor.has_value();
}

}  // namespace
}  // namespace coppice::robot::simulation

int main(int argc, char** argv) {
  namespace robot = coppice::robot;
  robot::simulation::Settings settings;
  const robot::Parameters parameters = ParametersOf(settings);
  if (const auto status =
          robot::StartNode(argc, argv, "simulator", robot::simulation::kHelp, parameters)) {
    return *status;
  }
  if (!Derive(settings)) return 2;
  ros::param::set("/use_sim_time", true);
  robot::simulation::SimulatorNode(settings).Run();
  ros::shutdown();
  return 0;
}
