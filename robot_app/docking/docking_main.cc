// coppice-docking: the dock controller as the ROS node /docking.
#include <actionlib/server/simple_action_server.h>
#include <coppice_msgs/DockingAction.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/BatteryState.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/battery_message.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/docking/dock_controller.h"

namespace coppice::robot::docking {
namespace {

constexpr char kHelp[] =
    "coppice-docking: drives onto the charging station and off it, as the ROS node /docking.\n"
    "  action      docking (coppice_msgs/Docking)\n"
    "  subscribes  /battery_state /scan /odom /tf /tf_static\n"
    "  publishes   /cmd_vel, only during a manoeuvre\n"
    "Only a charging current that lasts, or a charger that says the battery is full, is success.\n"
    "Undocking works without localization, which does not run while the robot charges: as long as\n"
    "the contacts touch the robot is where it docks.\n";

constexpr double kControlPeriod = 0.05;  // ROS time [s]
constexpr double kPoseTimeout = 1.0;     // an older pose is not driven with [s]
constexpr double kScanTimeout = 1.0;     // nor is an older scan
constexpr double kBatteryTimeout = 5.0;  // an older reading of the battery does not count [s]
constexpr double kBlindTimeout = 10.0;   // standing still until they are back, no longer [s]
constexpr double kLargestOffset = 0.2;   // of an approach [m]
constexpr double kPointRange = 3.0;      // of obstacles [m]

struct Settings {
  DockSettings dock;
  Frames frames;
};

Parameters ParametersOf(Settings& settings) {
  DockSettings& dock = settings.dock;
  return WithFrames(
      {{"docked_x", &dock.docked.x, -1e4, 1e4, "base_link when docked, on the map [m]"},
       {"docked_y", &dock.docked.y, -1e4, 1e4, "[m]"},
       {"docked_yaw", &dock.docked.yaw, -7, 7, "[rad]"},
       {"staging_distance", &dock.staging_distance, 0.3, 5, "from there to the staging pose [m]"},
       {"farthest_start", &dock.farthest_start, 0.1, 10, "from that; else it is refused [m]"},
       {"approach_speed", &dock.approach_speed, 0.03, 0.15, "into the station [m/s]"},
       {"attempts", &dock.attempts, 1, 20, "until it gives up"},
       {"charging_above", &dock.charging_above, 0, 1000, "a current into the battery counts [A]"},
       {"charging_for", &dock.charging_for, 0, 600, "and must last so long [s]"},
       {"charging_within", &dock.charging_within, 0.1, 600, "after the contact, at most [s]"},
       {"robot_radius", &dock.robot_radius, 0.05, 3, "[m]"}},
      settings.frames);
}

class DockingNode {
 public:
  explicit DockingNode(const Settings& settings)
      : settings_(settings.dock),
        controller_(settings.dock),
        pose_(settings.frames),
        server_(node_, "docking", false) {
    command_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
    subscribers_.push_back(node_.subscribe<sensor_msgs::BatteryState>(
        "/battery_state", 5, [this](const sensor_msgs::BatteryState::ConstPtr& message) {
          battery_ = ToBatteryReading(*message, {});
          battery_stamp_ = message->header.stamp.toSec();
        }));
    subscribers_.push_back(node_.subscribe<nav_msgs::Odometry>(
        "/odom", 1, [this](const nav_msgs::Odometry::ConstPtr& message) {
          wheels_ = ToPose2D(message->pose.pose);
          wheels_stamp_ = message->header.stamp.toSec();
        }));
    subscribers_.push_back(node_.subscribe<sensor_msgs::LaserScan>(
        "/scan", 1, [this](const sensor_msgs::LaserScan::ConstPtr& message) {
          const auto scan = pose_.UsableScan(*message);
          if (!scan) return;
          points_ = PointsInBase(*scan, kPointRange);
          scan_stamp_ = scan->stamp;
        }));
    server_.registerGoalCallback([this] { OnGoal(); });
    server_.registerPreemptCallback([this] {
      if (!server_.isNewGoalAvailable()) OnCancel();
    });
    server_.start();
    timer_ = node_.createTimer(ros::Duration(kControlPeriod),
                               [this](const ros::TimerEvent&) { Control(); });
  }

 private:
  // From the localization; or, on the way off the station, from where it began by the wheels.
  std::optional<Pose2D> PoseOnMap(const DockInput& input) {
    const auto pose = pose_.Newest();
    if (pose && input.now - pose->stamp < kPoseTimeout) return pose->pose;
    if (goal_->dock || input.now - wheels_stamp_ > kPoseTimeout) return std::nullopt;
    if (!is_started_ && input.battery_known && input.docked) wheels_docked_ = wheels_;
    if (!wheels_docked_) return std::nullopt;
    return Compose(settings_.docked, RelativeTo(*wheels_docked_, wheels_));
  }

  // What is known now; a problem if that is not enough to drive with.
  Expected<DockInput> Input() {
    DockInput input;
    input.now = ros::Time::now().toSec();
    input.current = battery_.current;
    input.docked = leaves::StandsOnStation(battery_, settings_.charging_above).value_or(false);
    input.full = battery_.charger == leaves::ChargerState::kFull;
    input.battery_known = input.now - battery_stamp_ < kBatteryTimeout;
    const auto pose = PoseOnMap(input);
    if (input.now - scan_stamp_ > kScanTimeout) return Problem{"there is no laser scan"};
    if (!pose) return Problem{"the robot's pose is not known"};
    input.pose = *pose;
    input.obstacles = points_;
    return input;
  }

  void OnGoal() {
    goal_ = server_.acceptNewGoal();
    is_started_ = false;
    blind_for_ = 0;
    wheels_docked_.reset();
    if (!(std::abs(goal_->lateral_offset) <= kLargestOffset)) {
      Finish(false, "the lateral offset is too large");
    }
  }

  void Start(const DockInput& input) {
    if (is_started_) return;
    is_started_ = true;
    if (goal_->press_on) {
      controller_.StartPressingOn(input);
    } else if (goal_->dock) {
      controller_.StartDocking(input, goal_->lateral_offset, goal_->attempts);
    } else {
      controller_.StartUndocking(input);
    }
  }

  void OnCancel() {
    if (!server_.isActive()) return;
    controller_.Cancel();
    command_.publish(geometry_msgs::Twist());
    coppice_msgs::DockingResult result;
    result.message = controller_.message();
    server_.setPreempted(result, result.message);
  }

  void Finish(bool ok, const std::string& message) {
    coppice_msgs::DockingResult result;
    result.ok = ok;
    result.message = message;
    if (ok) {
      ROS_INFO("%s", message.c_str());
      server_.setSucceeded(result, message);
    } else {
      ROS_WARN("%s", message.c_str());
      server_.setAborted(result, message);
    }
  }

  // A sensor that is late, as when its node has just started, does not end the manoeuvre.
  void StandStill(const std::string& missing) {
    command_.publish(geometry_msgs::Twist());
    blind_for_ += kControlPeriod;
    if (blind_for_ < kBlindTimeout) return;
    controller_.Cancel();
    Finish(false, missing);
  }

  void Control() {
    if (!server_.isActive()) return;
    const Expected<DockInput> input = Input();
    if (!input) return StandStill(input.problem());
    blind_for_ = 0;
    Start(*input);
    command_.publish(ToTwist(controller_.Update(*input)));  // zero once it has ended
    if (!controller_.active()) {
      return Finish(controller_.phase() == DockController::Phase::kDone, controller_.message());
    }
    coppice_msgs::DockingFeedback feedback;
    feedback.phase = ToString(controller_.phase());
    feedback.failed_attempts = static_cast<std::uint8_t>(controller_.failed_attempts());
    feedback.why_failed = controller_.why_failed();
    server_.publishFeedback(feedback);
  }

  DockSettings settings_;
  ros::NodeHandle node_;
  DockController controller_;
  RobotPose pose_;
  leaves::BatteryReading battery_;       // the newest
  double battery_stamp_ = 0;             // [s]
  Pose2D wheels_;                        // base_link in the frame of /odom
  double wheels_stamp_ = 0;              // [s]
  std::optional<Pose2D> wheels_docked_;  // wheels_ in the station, before undocking
  std::vector<Point2D> points_;
  double scan_stamp_ = 0;
  actionlib::SimpleActionServer<coppice_msgs::DockingAction> server_;
  coppice_msgs::DockingGoal::ConstPtr goal_;
  bool is_started_ = false;  // the goal; else it waits for the sensors
  double blind_for_ = 0;     // not all is known that the controller needs, since then [s]
  ros::Publisher command_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Timer timer_;
};

}  // namespace
}  // namespace coppice::robot::docking

int main(int argc, char** argv) {
  namespace robot = coppice::robot;
  robot::docking::Settings settings;
  const robot::Parameters parameters = ParametersOf(settings);
  if (const auto status =
          robot::StartNode(argc, argv, "docking", robot::docking::kHelp, parameters)) {
    return *status;
  }
  ros::NodeHandle keep_alive;
  robot::docking::DockingNode node(settings);
  ros::spin();
  return 0;
}
