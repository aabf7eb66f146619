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
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <thread>

#include "robot_app/common/ros_support.h"
#include "robot_app/simulation/cloud_message.h"
#include "robot_app/simulation/faults.h"
#include "robot_app/simulation/late_messages.h"
#include "robot_app/simulation/node_signals.h"
#include "robot_app/simulation/pace.h"
#include "robot_app/simulation/sensor_messages.h"
#include "robot_app/simulation/shipped_files.h"

namespace coppice::robot::simulation {
namespace {

constexpr char kHelp[] =
    "coppice-simulator: the simulated robot and its floor, as the ROS node /simulator.\n"
    "  subscribes  /cmd_vel /tf (whether the robot keeps up)\n"
    "              /simulation/speed (std_msgs/Float64: another speed from now on)\n"
    "  publishes   /clock /odom /scan /imu/data /battery_state /map /tf /tf_static\n"
    "              /sonar/left /sonar/front /sonar/right (sensor_msgs/Range)\n"
    "              /emergency_stop (std_msgs/Bool, true while pressed)\n"
    "              /simulation/truth (for evaluation only)\n"
    "              /velodyne_points (the 3-D lidar, while somebody subscribes)\n"
    "              /simulation/world (for coppice-simulated-cameras and evaluation, the same)\n"
    "  service     /simulation/inject_fault (coppice_msgs/InjectFault: breaks things)\n"
    "Faster than real time it waits for a robot that is late, and /clock comes at 20 Hz for 50.\n";

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr double kStep = 0.02;         // s of simulated time
constexpr double kFastClock = 0.05;    // the same; as often as the robot's controls look at it
constexpr double kLongestBurst = 0.2;  // s of wall time
constexpr double kLongestRest = 0.1;   // the same
constexpr double kFastest = 1000;      // times real time
constexpr double kStartTime = 1000;    // s; so that "ten seconds ago" exists for everybody

double WallTime() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

// In whole microseconds: the world's time is a sum of steps, and 0.8 s should not read 0.799999999.
ros::Time ToRosTime(double time) {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(std::llround((kStartTime + time) * 1e6)) * 1000);
  return stamp;
}

struct Settings {
  std::string floor_file = kInstitute;
  std::string robot_file = kSobi;
  std::optional<Pose2D> start;
  double speed = 1;
  bool localization = true;
  bool odometry_tf = true;
  WorldOptions world;
  Floor floor;
  RobotDescription robot;
};

Parameters ParametersOf(Settings& settings) {
  WorldOptions& world = settings.world;
  return {
      {"floor", &settings.floor_file, "description of the floor, a YAML file"},
      {"robot", &settings.robot_file, "description of the robot, a URDF file"},
      {"seed", &world.seed, 0, 1e9, "of the sensors' noise"},
      {"speed", &settings.speed, 0, kFastest, "times real time; 0: as fast as possible"},
      {"start", &settings.start, "\"X Y YAW\" on the map; none: docked"},
      {"state_of_charge", &world.state_of_charge, 0, 1, "of the battery"},
      {"localization", &settings.localization, "publishes map -> odom"},
      {"odometry_tf", &settings.odometry_tf, "publishes odom -> base_link"},
  };
}

// The same with the lidar's faults: without any points or without those of some rings.
Cloud WithFaults(Cloud cloud, const SensorFaults& faults) {
  const bool is_blind = faults.IsBlind("/velodyne_points");
  for (CloudPoint& point : cloud.points) {
    if (is_blind || faults.lost_rings().count(point.ring) > 0) point.x = point.y = point.z = kNaN;
  }
  return cloud;
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
                 "/emergency_stop", "/tf", "/simulation/truth", "/camera/front", "/camera/rear",
                 "/sonar/left", "/sonar/front", "/sonar/right"},
                [this](const std::string& node, int signal) {
                  return node_signals_.Send(node, signal);
                }) {
    Advertise();
    PublishMap();
    tf_static_.publish(ToMessage(settings_.robot, ToRosTime(0)));
  }

  void Run() {
    while (ros::ok()) {
      ros::getGlobalCallbackQueue()->callAvailable();
      if (WallTime() >= next_) {
        Step();
        // Too slow a computer slows the simulated time down; it does not catch up in a burst.
        next_ = std::max(next_ + WallTimeOfStep(), WallTime() - kLongestBurst);
      }
      // At a speed of nearly nothing the next step is years away; an end or another speed is not.
      const double rest = std::clamp(next_ - WallTime(), 0.0, kLongestRest);
      std::this_thread::sleep_for(std::chrono::duration<double>(rest));
    }
  }

 private:
  void Advertise() {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    odom_ = node_.advertise<nav_msgs::Odometry>("/odom", 20);
    scan_ = node_.advertise<sensor_msgs::LaserScan>("/scan", 10);
    cloud_ = node_.advertise<sensor_msgs::PointCloud2>("/velodyne_points", 5);
    for (const char* const name : kSonars) {
      sonars_.push_back(node_.advertise<sensor_msgs::Range>(std::string("/sonar/") + name, 10));
    }
    imu_ = node_.advertise<sensor_msgs::Imu>("/imu/data", 50);
    battery_ = node_.advertise<sensor_msgs::BatteryState>("/battery_state", 5);
    map_ = node_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 50);
    tf_static_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    stop_ = node_.advertise<std_msgs::Bool>("/emergency_stop", 5, true);
    truth_ = node_.advertise<geometry_msgs::PoseStamped>("/simulation/truth", 5);
    state_ = node_.advertise<coppice_msgs::SimulatedWorld>("/simulation/world", 1);
    command_subscriber_ = node_.subscribe<geometry_msgs::Twist>(
        "/cmd_vel", 1, [this](const geometry_msgs::Twist::ConstPtr& twist) {
          command_ = Velocity{twist->linear.x, twist->angular.z};
        });
    transform_subscriber_ = node_.subscribe<tf2_msgs::TFMessage>(
        "/tf", 100,
        [this](const tf2_msgs::TFMessage::ConstPtr& message) { OnTransforms(*message); });
    speed_subscriber_ = node_.subscribe<std_msgs::Float64>(
        "/simulation/speed", 1,
        [this](const std_msgs::Float64::ConstPtr& message) { OnSpeed(message->data); });
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
    world_.SetSonarsOn(std::any_of(sonars_.begin(), sonars_.end(), [](const auto& sonar) {
      return sonar.getNumSubscribers() > 0;
    }));
    world_.Step(kStep, command_);
    command_.reset();
    faults_.Update();
    stamp_ = ToRosTime(world_.time());
    if (clock_due_.Due(world_.time())) PublishClock();
    PublishMotion();
    PublishScan();
    PublishCloud();
    PublishSonars();
    PublishImu();
    if (battery_due_.Due(world_.time())) PublishBattery();
    PublishEmergencyStop();
    if (truth_due_.Due(world_.time())) PublishTruth();
    if (state_due_.Due(world_.time())) PublishState();
    late_.Send(world_.time());
  }

  void OnSpeed(double speed) {
    if (!(speed >= 0 && speed <= kFastest)) {
      ROS_WARN("/simulation/speed is %g, expected 0 to %g", speed, kFastest);
      return;
    }
    pace_.set_speed(speed);
    next_ = std::min(next_, WallTime() + WallTimeOfStep());
    clock_due_ = Every(ClockPeriod());
  }

  double WallTimeOfStep() const {
    return pace_.Seconds(kStep, kStartTime + world_.time(), WallTime());
  }

  // It wakes every program of the robot: more than half of all messages.
  double ClockPeriod() const { return pace_.is_fast() ? kFastClock : kStep; }

  // The robot's own part of the way from the map to its base.
  void OnTransforms(const tf2_msgs::TFMessage& message) {
    for (const auto& transform : message.transforms) {
      const std::string& child = transform.child_frame_id;
      if (child != "odom" && child != "base_link") continue;
      pace_.Heard(child, transform.header.stamp.toSec(), WallTime());
    }
  }

  template <typename Message>
  void Publish(const ros::Publisher& publisher, const Message& message) {
    const std::string topic = publisher.getTopic();
    for (int copies = faults_.Copies(topic); copies > 0; --copies) {
      const double lag = faults_.sensors().Lag(topic);
      if (lag > 0) {
        late_.Add(world_.time() + lag, publisher, message);
      } else {
        publisher.publish(message);
      }
    }
  }

  void PublishClock() {
    rosgraph_msgs::Clock message;
    message.clock = stamp_;
    clock_.publish(message);
  }

  void PublishMotion() {
    const Odometry& odometry = world_.odometry();
    if (odometry.time() == odometry_time_) return;
    odometry_time_ = odometry.time();
    nav_msgs::Odometry odom = ToMessage(odometry);
    odom.header.stamp = stamp_;
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
    sensor_msgs::LaserScan message = ToMessage(scan, world_.lidar().options());
    message.header.stamp = stamp_;
    if (faults_.sensors().IsBlind("/scan")) {
      std::fill(message.ranges.begin(), message.ranges.end(), kNaN);
    }
    Publish(scan_, message);
  }

  // Between two turns. Faster than real time the 3-D lidar and who looks at its clouds would take
  // more of the computer than all else; so it turns as often in a second of wall time as a real
  // one.
  std::chrono::nanoseconds LidarRest() const {
    const double period = world_.lidar_3d().options().period;
    const double turn = pace_.speed() > 0 ? period / pace_.speed() : 0;
    return std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * std::max(0.0, period - turn)));
  }

  void PublishCloud() {
    const Cloud& cloud = world_.lidar_3d().cloud();
    if (cloud.points.empty() || cloud.time == cloud_time_) return;
    cloud_time_ = cloud.time;
    lidar_rests_until_ = std::chrono::steady_clock::now() + LidarRest();
    sensor_msgs::PointCloud2 message =
        ToMessage(WithFaults(cloud, faults_.sensors()), world_.lidar_3d().options().rings);
    message.header.stamp = ToRosTime(cloud.time);
    message.header.frame_id = "velodyne";
    Publish(cloud_, message);
  }

  void PublishSonars() {
    const Echoes& echoes = world_.echoes();
    if (echoes.time == echoes_time_) return;
    echoes_time_ = echoes.time;
    for (std::size_t i = 0; i < sonars_.size(); ++i) {
      const bool is_blind = faults_.sensors().IsBlind(sonars_[i].getTopic());
      sensor_msgs::Range message =
          ToMessage(is_blind ? kNaN : echoes.ranges[i], world_.sonars()[i].options());
      message.header.stamp = stamp_;
      message.header.frame_id = std::string("sonar_") + kSonars[i];
      Publish(sonars_[i], message);
    }
  }

  void PublishImu() {
    sensor_msgs::Imu message = ToMessage(world_.imu());
    message.header.stamp = stamp_;
    if (faults_.sensors().IsBlind("/imu/data")) {
      message.angular_velocity.z = kNaN;
      message.linear_acceleration.x = message.linear_acceleration.y = kNaN;
      message.linear_acceleration.z = kNaN;
    }
    Publish(imu_, message);
  }

  void PublishBattery() {
    if (!faults_.battery_frozen()) battery_state_ = ToMessage(world_.battery(), world_.docked());
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
    message.pose = ToPoseMessage(world_.robot());
    Publish(truth_, message);
  }

  void PublishMap() {
    nav_msgs::OccupancyGrid message =
        ToMessage(MakeGridMap(settings_.floor, settings_.floor.resolution));
    message.header.stamp = ToRosTime(0);
    message.info.map_load_time = message.header.stamp;
    map_.publish(message);
  }

  void PublishState() {
    if (state_.getNumSubscribers() == 0) return;
    coppice_msgs::SimulatedWorld message = ToMessage(world_);
    message.header.stamp = stamp_;
    for (const char* const name : kCameras) {
      const CameraFault fault = faults_.sensors().Of(name, world_.time());
      const std::string topic = std::string("/camera/") + name;
      coppice_msgs::SimulatedCamera camera;
      camera.name = name;
      camera.is_covered = fault.is_covered;
      camera.broken = fault.broken;
      camera.lag = faults_.sensors().Lag(topic);
      camera.copies = static_cast<std::uint8_t>(faults_.Copies(topic));
      message.cameras.push_back(camera);
    }
    state_.publish(message);
  }

  Settings settings_;
  Pace pace_{settings_.speed};
  double next_ = WallTime();  // step
  World world_;
  NodeSignals node_signals_;
  Faults faults_;
  ros::NodeHandle node_;
  LateMessages late_;
  ros::Publisher clock_, odom_, scan_, cloud_, imu_, battery_, map_, tf_, tf_static_, stop_, truth_,
      state_;
  std::vector<ros::Publisher> sonars_;  // in the order of kSonars
  ros::Subscriber command_subscriber_;
  ros::Subscriber transform_subscriber_;
  ros::Subscriber speed_subscriber_;
  ros::ServiceServer fault_service_;
  std::optional<Velocity> command_;
  ros::Time stamp_;
  sensor_msgs::BatteryState battery_state_;
  bool emergency_stop_ = false;
  double odometry_time_ = -1;
  double scan_time_ = -1;
  double cloud_time_ = -1;
  double echoes_time_ = -1;
  std::chrono::steady_clock::time_point lidar_rests_until_{};
  Every clock_due_{ClockPeriod()};
  Every localization_due_{0.1};
  Every battery_due_{0.5};
  Every stop_due_{0.5};
  Every truth_due_{0.2};
  Every state_due_{0.1};
};

bool Refuse(const std::string& problem) {
  std::fprintf(stderr, "coppice-simulator: %s\n", problem.c_str());
  return false;
}

// What follows from the parameters. False, having said why, if the floor or the robot cannot be
// read.
bool Derive(Settings& settings) {
  if (settings.start) {
    settings.world.start = Pose2{settings.start->x, settings.start->y, settings.start->yaw};
  }
  Expected<Floor> floor = FindFloor(settings.floor_file);
  if (!floor) return Refuse(floor.problem());
  settings.floor = *std::move(floor);
  Expected<RobotDescription> robot = FindRobot(settings.robot_file);
  if (!robot) return Refuse(robot.problem());
  settings.robot = *std::move(robot);
  const Outcome applied = Apply(settings.robot, settings.world);
  return applied.ok() || Refuse(settings.robot_file + ": " + applied.problem());
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
  ros::param::set("/robot_description", settings.robot.text());
  robot::simulation::SimulatorNode(settings).Run();
  ros::shutdown();
  return 0;
}
