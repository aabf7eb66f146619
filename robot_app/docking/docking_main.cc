// coppice-docking: the dock controller as the ROS node /docking.
#include <coppice_msgs/DockingAction.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <sensor_msgs/BatteryState.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/actions/goal_server.h"
#include "robot_app/common/battery_message.h"
#include "robot_app/common/places/station_place.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/service_caller.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/docking/dock_controller.h"
#include "robot_app/docking/station_memory.h"

namespace coppice::robot::docking {
namespace {

constexpr char kHelp[] =
    "coppice-docking: drives onto the charging station and off it, as the ROS node /docking.\n"
    "  action      docking (coppice_msgs/Docking)\n"
    "  subscribes  /battery_state /scan /tf /tf_static\n"
    "  publishes   /cmd_vel, only during a manoeuvre\n"
    "              /docking/station (geometry_msgs/PoseStamped: base_link when docked, as it is seen)\n"
    "              /docking/path (nav_msgs/Path: the way into the station)\n"
    "The station is recognized by its landmark. Where it should be (the place of the category\n"
    "\"station\" in ~places, later where it was seen the last time, kept in ~station_file) only tells\n"
    "where to look.\n"
    "Only a charging current that lasts, or a charger that says the battery is full, is success.\n"
    "Nothing needs the localization, which does not run while the robot charges.\n";

constexpr double kControlPeriod = 0.05;  // ROS time [s]
constexpr double kPoseTimeout = 1.0;     // an older pose is not driven with [s]
constexpr double kScanTimeout = 1.0;     // nor is an older scan
constexpr double kBatteryTimeout = 5.0;  // an older reading of the battery does not count [s]
constexpr double kFirstLook = 0.5;       // for the landmark, before a manoeuvre begins [s]
constexpr double kBlindTimeout = 10.0;   // standing still until they are back, no longer [s]
constexpr double kLargestOffset = 0.2;   // of an approach [m]
constexpr double kPointRange = 3.0;      // of obstacles [m]
constexpr double kPathStep = 0.05;       // of what is shown of the path [m]

struct Settings {
  DockSettings dock;
  LandmarkSettings landmark;
  std::string places = "none";
  std::optional<Pose2D> prior;  // base_link when docked, on the map
  std::string station_file = "none";
  Frames frames;
};

Parameters ParametersOf(Settings& settings) {
  DockSettings& dock = settings.dock;
  return WithFrames(
      {{"places", &settings.places, "file with the place of the category \"station\""},
       {"station_file", &settings.station_file, "keeps where it was when the robot docked"},
       {"landmark_leg", &dock.landmark.leg, 0.1, 2, "of the landmark [m]"},
       {"landmark_opening", &dock.landmark.opening, 1, 3, "between its legs [rad]"},
       {"landmark_ahead", &dock.landmark.ahead, 0.1, 2, "its corner before base_link, docked [m]"},
       {"scan_noise", &settings.landmark.noise, 0.001, 0.1, "standard deviation of a range [m]"},
       {"staging_distance", &dock.staging_distance, 0.3, 5,
        "staging pose before the docked one [m]"},
       {"farthest_start", &dock.farthest_start, 0.1, 10, "from that; else it is refused [m]"},
       {"turn_radius", &dock.turn_radius, 0.2, 3, "of the way into the station [m]"},
       {"approach_speed", &dock.approach_speed, 0.03, 0.15, "on its last metre [m/s]"},
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
        frames_(settings.frames),
        station_(settings.prior, settings.station_file),
        tracker_(settings.landmark),
        controller_(settings.dock),
        pose_(settings.frames),
        server_(
            node_, "docking", [this](const auto& goal) { OnGoal(goal); }, [this] { OnCancel(); }) {
    command_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
    seen_ = node_.advertise<geometry_msgs::PoseStamped>("/docking/station", 1);
    path_ = node_.advertise<nav_msgs::Path>("/docking/path", 1);
    subscribers_.push_back(node_.subscribe<sensor_msgs::BatteryState>(
        "/battery_state", 5, [this](const sensor_msgs::BatteryState::ConstPtr& message) {
          const auto stamp = StampOfNow(message->header, "/battery_state");
          if (!stamp) return;
          battery_ = ToBatteryReading(*message, {});
          battery_stamp_ = *stamp;
        }));
    subscribers_.push_back(node_.subscribe<sensor_msgs::LaserScan>(
        "/scan", 1, [this](const sensor_msgs::LaserScan::ConstPtr& message) {
          const auto scan = pose_.UsableScan(*message);
          if (!scan) return;
          points_ = PointsInBase(*scan, kPointRange);
          scan_stamp_ = scan->stamp;
          LookForStation(*scan, message->header.stamp);
        }));
    server_.Start();
    timer_ = node_.createTimer(ros::Duration(kControlPeriod),
                               [this](const ros::TimerEvent&) { Control(); });
  }

 private:
  // Where the station should be, in the frame of the odometry.
  std::optional<Pose2D> ExpectedStation() const {
    const auto odometry = pose_.OdometryInMap();
    if (!odometry || !station_.station()) return std::nullopt;
    return RelativeTo(odometry->pose, *station_.station());
  }

  // In every scan of a manoeuvre.
  void LookForStation(const LaserScan& scan, const ros::Time& stamp) {
    if (!server_.is_active()) return;
    const auto base = pose_.InOdometry(stamp);
    if (!base) return;
    tracker_.AddScan(scan, base->pose, ExpectedStation());
    if (!tracker_.seen()) return;
    geometry_msgs::PoseStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = frames_.odom;
    message.pose = ToPoseMessage(tracker_.seen()->docked);
    seen_.publish(message);
  }

  void PublishPath() {
    if (path_.getNumSubscribers() == 0) return;
    nav_msgs::Path message;
    message.header.stamp = ros::Time::now();
    message.header.frame_id = frames_.odom;
    const auto& path = controller_.path();
    for (double way = 0; path && way < path->length(); way += kPathStep) {
      geometry_msgs::PoseStamped pose;
      pose.header = message.header;
      pose.pose = ToPoseMessage(Compose(*controller_.station(), path->At(way)));
      message.poses.push_back(pose);
    }
    path_.publish(message);
  }

  // The next time the station is looked for where it was now. It is written on a thread of its own:
  // a disk that is slow holds up nobody who docks.
  void LearnStation() {
    const auto odometry = pose_.OdometryInMap();
    if (!tracker_.seen() || !odometry) return;
    if (ros::Time::now().toSec() - odometry->stamp > kPoseTimeout) return;
    const Pose2D station = Compose(odometry->pose, tracker_.seen()->docked);
    if (!station_.Learn(station) || is_saving_) return;
    is_saving_ = writer_.Add([this, station]() -> ServiceCaller::Finish {
      const Outcome saved = station_.Save(station);
      if (!saved) ROS_WARN("%s", saved.problem().c_str());
      return [this, station, is_saved = saved.ok()] {
        is_saving_ = false;
        if (is_saved) station_.HasSaved(station);
      };
    });
  }

  // What is known now; a problem if that is not enough to drive with.
  Expected<DockInput> Input() {
    DockInput input;
    input.now = ros::Time::now().toSec();
    input.current = battery_.current;
    input.docked = leaves::StandsOnStation(battery_, settings_.charging_above).value_or(false);
    input.full = battery_.charger == leaves::ChargerState::kFull;
    input.battery_known = input.now - battery_stamp_ < kBatteryTimeout;
    const auto pose = pose_.InOdometry();
    if (input.now - scan_stamp_ > kScanTimeout) return Problem{"there is no laser scan"};
    if (!pose || input.now - pose->stamp > kPoseTimeout) {
      return Problem{"there is no odometry"};
    }
    input.pose = pose->pose;
    input.obstacles = points_;
    input.seen = tracker_.seen();
    input.expected = ExpectedStation();
    return input;
  }

  void OnGoal(const coppice_msgs::DockingGoal& goal) {
    goal_ = goal;
    is_started_ = false;
    accepted_ = ros::Time::now().toSec();
    blind_for_ = 0;
    tracker_.Reset();
    if (!(std::abs(goal_.lateral_offset) <= kLargestOffset)) {
      Finish(false, "the lateral offset is too large");
    }
  }

  // Some scans first: what is begun depends on where the robot stands.
  bool HasLooked(const DockInput& input) const {
    return input.seen || std::abs(input.now - accepted_) > kFirstLook;
  }

  void Start(const DockInput& input) {
    if (is_started_) return;
    is_started_ = true;
    if (goal_.press_on) {
      controller_.StartPressingOn(input);
    } else if (goal_.dock) {
      controller_.StartDocking(input, goal_.lateral_offset, goal_.attempts);
    } else {
      controller_.StartUndocking(input);
    }
  }

  void OnCancel() {
    controller_.Cancel();
    command_.publish(geometry_msgs::Twist());
    coppice_msgs::DockingResult result;
    result.message = controller_.message();
    server_.Cancel(result, result.message);
  }

  void Finish(bool ok, const std::string& message) {
    coppice_msgs::DockingResult result;
    result.ok = ok;
    result.message = message;
    if (ok) {
      ROS_INFO("%s", message.c_str());
      server_.Succeed(result, message);
    } else {
      ROS_WARN("%s", message.c_str());
      server_.Abort(result, message);
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

  void EndBecauseTimeWasSetBack() {
    controller_.Cancel();
    command_.publish(geometry_msgs::Twist());
    Finish(false, "time was set back");
  }

  void Control() {
    writer_.RunFinished();
    const double last = std::exchange(controlled_, ros::Time::now().toSec());
    if (!server_.is_active()) return;
    // All that the manoeuvre waits for would last until that time has come again.
    if (controlled_ < last) return EndBecauseTimeWasSetBack();
    const Expected<DockInput> input = Input();
    if (!input) return StandStill(input.problem());
    blind_for_ = 0;
    if (!is_started_ && !HasLooked(*input)) return command_.publish(geometry_msgs::Twist());
    Start(*input);
    command_.publish(ToTwist(controller_.Update(*input)));  // zero once it has ended
    PublishPath();
    if (!controller_.active()) {
      const bool done = controller_.phase() == DockController::Phase::kDone;
      if (done && goal_.dock) LearnStation();
      return Finish(done, controller_.message());
    }
    coppice_msgs::DockingFeedback feedback;
    feedback.phase = ToString(controller_.phase());
    feedback.failed_attempts = static_cast<std::uint8_t>(controller_.failed_attempts());
    feedback.why_failed = controller_.why_failed();
    server_.Publish(feedback);
  }

  DockSettings settings_;
  Frames frames_;
  StationMemory station_;
  ros::NodeHandle node_;
  StationTracker tracker_;
  DockController controller_;
  RobotPose pose_;
  leaves::BatteryReading battery_;  // the newest
  double battery_stamp_ = 0;        // [s]
  std::vector<Point2D> points_;
  double scan_stamp_ = 0;
  GoalServer<coppice_msgs::DockingAction> server_;
  coppice_msgs::DockingGoal goal_;
  bool is_started_ = false;  // the goal; else it waits for the sensors
  double accepted_ = 0;      // the goal [s]
  double controlled_ = 0;    // last [s]
  double blind_for_ = 0;     // not all is known that the controller needs, since then [s]
  ros::Publisher command_, seen_, path_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Timer timer_;
  bool is_saving_ = false;  // where the station is
  ServiceCaller writer_;
};

}  // namespace
}  // namespace coppice::robot::docking

int main(int argc, char** argv) {
  using namespace coppice::robot::docking;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(argc, argv, "docking", kHelp, [](Settings& settings) {
    settings.landmark.shape = settings.dock.landmark;
    if (!coppice::robot::ReadStation(settings.places, settings.prior)) return 2;
    DockingNode node(settings);
    ros::spin();
    return 0;
  });
}
