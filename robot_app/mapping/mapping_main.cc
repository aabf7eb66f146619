// coppice-mapping: the mapper of this folder as the ROS node /mapping.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <optional>
#include <string>

#include "robot_app/common/places/pose_file.h"
#include "robot_app/common/places/station_place.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/mapping/map_file.h"
#include "robot_app/mapping/map_message.h"
#include "robot_app/mapping/mapper.h"

namespace coppice::robot::mapping {
namespace {

constexpr char kHelp[] =
    "coppice-mapping: makes a map while a person drives the robot, as the ROS node /mapping.\n"
    "  subscribes  /scan /odometry/filtered /tf_static (of the scanner)\n"
    "  publishes   /map (nav_msgs/OccupancyGrid, latched), tf map -> odom, /diagnostics\n"
    "  service     /mapping/save (std_srvs/Trigger: writes the map to ~map_file)\n"
    "A map that nobody has saved at the end goes to ~map_file with _unsaved in its name. It\n"
    "begins where ~last_pose_file says, which the localization has left, else at ~start_pose.\n";

constexpr double kStatePeriod = 1;  // wall time [s]

struct Settings {
  MappingSettings mapping;
  double map_period = 2;  // [s]
  std::optional<Pose2D> start;
  std::string places = "none";
  std::string map_file = "none";
  std::string last_pose_file = "none";

  Pose2D Start() const { return LoadPose(last_pose_file).value_or(start.value_or(Pose2D())); }
  Frames frames;
};

Parameters ParametersOf(Settings& settings) {
  MappingSettings& mapping = settings.mapping;
  return WithFrames(
      {{"map_file", &settings.map_file, "the YAML file of the map"},
       {"start_pose", &settings.start, "\"X Y YAW\" at the start"},
       {"places", &settings.places, "else on the station of this file, else 0 0 0"},
       {"last_pose_file", &settings.last_pose_file, "where it was last, and is at the end"},
       {"range", &mapping.range, 1, 100, "beams are believed so far [m]"},
       {"resolution", &mapping.resolution, 0.01, 1, "of the map [m]"},
       {"map_period", &settings.map_period, 0.1, 3600, "between maps on /map [s]"},
       {"step", &mapping.step, 0.05, 5, "a scan is kept after so much way [m]"},
       {"turn", &mapping.turn, 0.05, 3, "or after such a turn [rad]"},
       {"drift", &mapping.drift, 0, 0.5, "before a loop is closed, share of the way"}},
      settings.frames);
}

// Beside the map: what nobody has saved.
std::string UnsavedName(const std::string& file) {
  std::filesystem::path path = file;
  return path.replace_filename(path.stem().string() + "_unsaved.yaml").string();
}

class MappingNode {
 public:
  explicit MappingNode(const Settings& settings)
      : settings_(settings),
        start_(settings.Start()),
        mapper_(settings.mapping, start_),
        frames_(settings.frames) {
    map_ = node_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 20);
    diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 5);
    odometry_subscriber_ = node_.subscribe<nav_msgs::Odometry>(
        "/odometry/filtered", 30,
        [this](const nav_msgs::Odometry::ConstPtr& message) { OnOdometry(*message); });
    scan_subscriber_ = node_.subscribe<sensor_msgs::LaserScan>(
        "/scan", 5, [this](const sensor_msgs::LaserScan::ConstPtr& message) { OnScan(*message); });
    using Service = std_srvs::Trigger;
    save_ = node_.advertiseService(
        "/mapping/save", boost::function<bool(Service::Request&, Service::Response&)>(
                             [this](Service::Request&, Service::Response& response) {
                               response.success = Save(settings_.map_file, response.message);
                               return true;
                             }));
    map_timer_ = node_.createTimer(ros::Duration(settings.map_period),
                                   [this](const ros::TimerEvent&) { PublishMap(); });
    state_timer_ = node_.createWallTimer(ros::WallDuration(kStatePeriod),
                                         [this](const ros::WallTimerEvent&) { PublishState(); });
    ROS_INFO("begins at (%.2f, %.2f, %.2f)", start_.x, start_.y, start_.yaw);
  }

  // Nothing that was driven for is lost because somebody forgot to save it.
  void KeepWhatIsUnsaved() {
    std::string message;
    if (mapper_.started() && mapper_.revision() != saved_ && settings_.map_file != "none") {
      Save(UnsavedName(settings_.map_file), message);
    }
    if (mapper_.started()) LeavePose();
  }

 private:
  void OnOdometry(const nav_msgs::Odometry& message) {
    const auto stamp = StampOfNow(message.header, "/odometry/filtered");
    if (!stamp || !IsValid(message.pose.pose)) return;
    mapper_.AddOdometry(*stamp, ToPose2D(message.pose.pose));
    PublishTransform();
  }

  void OnScan(const sensor_msgs::LaserScan& message) {
    auto scan = frames_.UsableScan(message);
    if (!scan) return;
    mapper_.AddScan(*std::move(scan));
    PublishTransform();
  }

  // Once for each scan that was used.
  void PublishTransform() {
    if (!mapper_.started() || mapper_.scan_stamp() == published_) return;
    published_ = mapper_.scan_stamp();
    tf2_msgs::TFMessage tf;
    tf.transforms.resize(1);
    tf.transforms[0].header.stamp = ros::Time(published_);
    tf.transforms[0].header.frame_id = settings_.frames.map;
    tf.transforms[0].child_frame_id = settings_.frames.odom;
    const geometry_msgs::Pose odom = ToPoseMessage(mapper_.odom_in_map());
    tf.transforms[0].transform.translation.x = odom.position.x;
    tf.transforms[0].transform.translation.y = odom.position.y;
    tf.transforms[0].transform.rotation = odom.orientation;
    tf_.publish(tf);
  }

  void PublishMap() {
    if (!mapper_.started() || mapper_.revision() == shown_) return;
    shown_ = mapper_.revision();
    map_.publish(ToMessage(mapper_.Map(), settings_.frames.map, ros::Time::now()));
  }

  void PublishState() {
    const MappingReport report = mapper_.Report();
    diagnostic_msgs::DiagnosticStatus status;
    status.name = "mapping: map";
    status.level = mapper_.started() && report.fits ? diagnostic_msgs::DiagnosticStatus::OK
                                                    : diagnostic_msgs::DiagnosticStatus::WARN;
    status.message = report.message;
    const auto add = [&status](const char* key, const std::string& value) {
      status.values.emplace_back();
      status.values.back().key = key;
      status.values.back().value = value;
    };
    add("key frames", std::to_string(report.key_frames));
    add("closed loops", std::to_string(report.loops));
    add("way [m]", std::to_string(report.way));
    add("score", std::to_string(report.score));
    add("saved", mapper_.revision() == saved_ ? "yes" : "no");
    diagnostic_msgs::DiagnosticArray message;
    message.header.stamp = ros::Time::now();
    message.status.push_back(status);
    diagnostics_.publish(message);
  }

  bool Save(const std::string& file, std::string& message) {
    if (file == "none") return message = "~map_file is not set", false;
    if (!mapper_.started()) return message = "there is no map yet", false;
    Diagnostics diagnostics;
    if (!SaveMap(file, mapper_.Map(), diagnostics)) {
      message = diagnostics.ToString();
      ROS_ERROR("%s", message.c_str());
      return false;
    }
    saved_ = mapper_.revision();
    message = "saved as " + file;
    ROS_INFO("%s", message.c_str());
    LeavePose();
    return true;
  }

  // For the localization, which goes on from there.
  void LeavePose() {
    if (settings_.last_pose_file == "none") return;
    const Outcome saved = SavePose(settings_.last_pose_file, mapper_.pose());
    if (!saved) ROS_WARN("%s", saved.problem().c_str());
  }

  const Settings settings_;
  const Pose2D start_;
  ros::NodeHandle node_;
  Mapper mapper_;
  RobotPose frames_;
  double published_ = 0;
  std::size_t shown_ = 0;  // revisions of the map
  std::size_t saved_ = 0;
  ros::Publisher map_;
  ros::Publisher tf_;
  ros::Publisher diagnostics_;
  ros::Subscriber odometry_subscriber_;
  ros::Subscriber scan_subscriber_;
  ros::ServiceServer save_;
  ros::Timer map_timer_;
  ros::WallTimer state_timer_;
};

}  // namespace
}  // namespace coppice::robot::mapping

int main(int argc, char** argv) {
  using namespace coppice::robot::mapping;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(argc, argv, "mapping", kHelp, [](Settings& settings) {
    if (!settings.start && !coppice::robot::ReadHome(settings.places, settings.start)) return 2;
    MappingNode node(settings);
    ros::spin();
    node.KeepWhatIsUnsaved();
    return 0;
  });
}
