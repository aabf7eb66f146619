// coppice-localization: the localizer of this folder as the ROS node /localization.
#include <coppice_msgs/LocalizationState.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "robot_app/common/places/pose_file.h"
#include "robot_app/common/places/station_place.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/service_caller.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/localization/localizer.h"

namespace coppice::robot::localization {
namespace {

constexpr char kHelp[] =
    "coppice-localization: finds and follows the robot on the map, as the ROS node /localization.\n"
    "  subscribes  /map /scan /odometry/filtered /tf_static (of the scanner)\n"
    "              /initialpose (geometry_msgs/PoseWithCovarianceStamped: a person says where)\n"
    "              /localization/hint (the same: a known place, to be confirmed by the scan)\n"
    "  publishes   tf map -> odom, /localization/pose with covariance, /localization/state\n"
    "  service     /global_localization (std_srvs/Empty: forget the pose, search the whole map)\n"
    "Where the robot may be at the start is believed only if the first scan fits there, and\n"
    "nowhere better.\n";

constexpr double kStatePeriod = 0.5;      // ROS time [s]
constexpr double kSavePeriod = 2;         // of the last pose, if it has changed; ROS time [s]
constexpr double kSaveWay = 0.05;         // changed [m], [rad]
constexpr double kPersonDeviation = 0.5;  // of /initialpose if the message does not tell [m]
constexpr double kPersonTurn = 0.26;      // rad

struct Settings {
  LocalizerSettings localizer;
  std::optional<Pose2D> start;
  std::string places = "none";
  std::string last_pose_file = "none";
  Frames frames;
};

Parameters ParametersOf(Settings& settings) {
  LocalizerSettings& localizer = settings.localizer;
  ParticleFilterSettings& filter = localizer.filter;
  return WithFrames(
      {{"start_pose", &settings.start, "\"X Y YAW\" where it may be at the start"},
       {"places", &settings.places, "else on the station of this file"},
       {"last_pose_file", &settings.last_pose_file, "or where it was last"},
       {"agree", &localizer.agree, 0.1, 1, "score from which a scan confirms the pose"},
       {"margin", &localizer.margin, 0, 0.5, "a rival agrees with so much fewer beams"},
       {"largest_deviation", &localizer.largest_deviation, 0.01, 10, "of a confirmed pose [m]"},
       {"uncertain_after", &localizer.uncertain_after, 0.3, 600, "not confirmed for so long [s]"},
       {"lost_after", &localizer.lost_after, 0.5, 3600, "[s]"},
       {"check_period", &localizer.check_period, 0.5, 3600, "looks for better places [s]"},
       {"fewest_particles", &filter.fewest, 50, 1e5, "at least so many"},
       {"most_particles", &filter.most, 100, 1e5, "at most so many"},
       {"seed", &localizer.seed, 0, 1e9, "of the random numbers"}},
      settings.frames);
}

class LocalizationNode {
 public:
  explicit LocalizationNode(const Settings& settings)
      : settings_(settings), localizer_(settings.localizer), frames_(settings.frames) {
    std::vector<Pose2D> expected;
    if (const auto last = LoadPose(settings.last_pose_file)) expected.push_back(*last);
    if (settings.start) expected.push_back(*settings.start);
    localizer_.Expect(expected);
    pose_ = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("/localization/pose", 10);
    state_ = node_.advertise<coppice_msgs::LocalizationState>("/localization/state", 10);
    tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 20);
    Subscribe();
    using Service = std_srvs::Empty;
    global_ = node_.advertiseService("/global_localization",
                                     boost::function<bool(Service::Request&, Service::Response&)>(
                                         [this](Service::Request&, Service::Response&) {
                                           localizer_.Relocalize();
                                           return true;
                                         }));
    timer_ = node_.createTimer(ros::Duration(kStatePeriod), [this](const ros::TimerEvent&) {
      PublishState(localizer_.Report(ros::Time::now().toSec()));
    });
  }

  /// At the end: exactly where the robot stands, for whoever takes over.
  void LeavePose() {
    writer_.reset();  // which has begun to write an earlier one
    const auto pose = localizer_.pose();
    if (pose && phase_ == LocalizationPhase::kOk) Save(*pose);
  }

 private:
  template <typename Message, typename Handle>
  void On(const std::string& topic, std::uint32_t queue, Handle handle) {
    subscribers_.push_back(node_.subscribe<Message>(
        topic, queue,
        boost::function<void(const boost::shared_ptr<const Message>&)>(
            [handle](const boost::shared_ptr<const Message>& message) { handle(*message); }),
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  }

  void Subscribe() {
    On<nav_msgs::OccupancyGrid>("/map", 1,
                                [this](const nav_msgs::OccupancyGrid& message) { OnMap(message); });
    On<nav_msgs::Odometry>("/odometry/filtered", 30, [this](const nav_msgs::Odometry& message) {
      const auto stamp = StampOfNow(message.header, "/odometry/filtered");
      if (!stamp || !IsValid(message.pose.pose)) return;
      localizer_.AddOdometry(*stamp, ToPose2D(message.pose.pose));
      PublishPose();
    });
    On<sensor_msgs::LaserScan>("/scan", 2, [this](const sensor_msgs::LaserScan& message) {
      if (auto scan = frames_.UsableScan(message)) {
        localizer_.AddScan(*std::move(scan));
        PublishPose();
      }
    });
    On<geometry_msgs::PoseWithCovarianceStamped>(
        "/initialpose", 1, [this](const geometry_msgs::PoseWithCovarianceStamped& message) {
          OnInitialPose(message);
        });
    On<geometry_msgs::PoseWithCovarianceStamped>(
        "/localization/hint", 5, [this](const geometry_msgs::PoseWithCovarianceStamped& message) {
          if (message.header.frame_id == settings_.frames.map && IsValid(message.pose.pose)) {
            localizer_.AddHint(message.header.stamp.toSec(), ToPose2D(message.pose.pose));
          }
        });
  }

  // Whoever shows the map may have been restarted: the same map again says nothing new.
  void OnMap(const nav_msgs::OccupancyGrid& message) {
    const Expected<OccupancyGrid> grid = ToGrid(message);
    if (!grid) {
      ROS_ERROR("%s; it is not used", grid.problem().c_str());
    } else if (!IsSame(*grid, map_)) {
      map_ = *grid;
      localizer_.SetMap(map_);
    }
  }

  static bool IsSame(const OccupancyGrid& a, const OccupancyGrid& b) {
    return a.frame.resolution == b.frame.resolution && a.frame.origin_x == b.frame.origin_x &&
           a.frame.origin_y == b.frame.origin_y && a.frame.width == b.frame.width &&
           a.cells == b.cells;
  }

  void OnInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
    if (message.header.frame_id != settings_.frames.map || !IsValid(message.pose.pose)) {
      ROS_WARN("/initialpose is not used: no valid pose in the frame %s",
               settings_.frames.map.c_str());
      return;
    }
    const auto deviation = [&message](int i, double otherwise) {
      const double variance = message.pose.covariance[i];
      return variance > 0 && std::isfinite(variance) ? std::sqrt(variance) : otherwise;
    };
    const Pose2D pose = ToPose2D(message.pose.pose);
    localizer_.SetPose(pose, std::max(deviation(0, kPersonDeviation), deviation(7, 0)),
                       deviation(35, kPersonTurn));
    ROS_INFO("set to (%.2f, %.2f, %.2f)", pose.x, pose.y, pose.yaw);
  }

  // Once for each scan that was used.
  void PublishPose() {
    const auto pose = localizer_.pose();
    const double stamp = localizer_.scan_stamp();
    if (!pose || stamp == published_) return;
    published_ = stamp;
    geometry_msgs::PoseWithCovarianceStamped message;
    message.header.stamp = ros::Time(stamp);
    message.header.frame_id = settings_.frames.map;
    message.pose.pose = ToPoseMessage(*pose);
    const Belief& belief = localizer_.belief();
    message.pose.covariance[0] = belief.variance_x;
    message.pose.covariance[1] = message.pose.covariance[6] = belief.covariance_xy;
    message.pose.covariance[7] = belief.variance_y;
    message.pose.covariance[35] = belief.variance_yaw;
    pose_.publish(message);
    tf2_msgs::TFMessage tf;
    tf.transforms.resize(1);
    tf.transforms[0].header = message.header;
    tf.transforms[0].child_frame_id = settings_.frames.odom;
    const geometry_msgs::Pose odom = ToPoseMessage(localizer_.odom_in_map());
    tf.transforms[0].transform.translation.x = odom.position.x;
    tf.transforms[0].transform.translation.y = odom.position.y;
    tf.transforms[0].transform.rotation = odom.orientation;
    tf_.publish(tf);
    const LocalizationReport report = localizer_.Report(stamp);
    if (report.phase != phase_) PublishState(report);
    if (report.phase == LocalizationPhase::kOk) SaveNowAndThen(*pose, stamp);
  }

  void PublishState(const LocalizationReport& report) {
    coppice_msgs::LocalizationState state;
    state.header.stamp = ros::Time::now();
    state.phase = static_cast<std::uint8_t>(report.phase);
    state.seconds_since_confirmed = report.seconds_since_confirmed;
    state.score = report.score;
    state.deviation = report.deviation;
    state.seconds_since_recognized = report.seconds_since_recognized;
    state.message = report.message;
    state_.publish(state);
    if (report.phase != phase_) ROS_INFO("%s", report.message.c_str());
    phase_ = report.phase;
  }

  // On a thread of its own: a disk that is slow holds up nobody who wants to know where it is.
  void SaveNowAndThen(const Pose2D& pose, double stamp) {
    writer_->RunFinished();
    if (is_saving_ || std::abs(stamp - saved_stamp_) < kSavePeriod) return;
    if (Distance(pose, saved_) < kSaveWay &&
        std::abs(NormalizeAngle(pose.yaw - saved_.yaw)) < kSaveWay) {
      return;
    }
    saved_ = pose;
    saved_stamp_ = stamp;
    is_saving_ = writer_->Add([this, pose]() -> ServiceCaller::Finish {
      Save(pose);
      return [this] { is_saving_ = false; };
    });
  }

  void Save(const Pose2D& pose) const {
    if (settings_.last_pose_file == "none") return;
    const Outcome saved = SavePose(settings_.last_pose_file, pose);
    if (!saved) ROS_WARN_THROTTLE(60, "%s", saved.problem().c_str());
  }

  Settings settings_;
  ros::NodeHandle node_;
  Localizer localizer_;
  OccupancyGrid map_;
  RobotPose frames_;
  double published_ = 0;
  LocalizationPhase phase_ = LocalizationPhase::kUncertain;  // as published
  Pose2D saved_{HUGE_VAL, HUGE_VAL, 0};
  double saved_stamp_ = 0;
  bool is_saving_ = false;
  ros::Publisher pose_;
  ros::Publisher state_;
  ros::Publisher tf_;
  std::vector<ros::Subscriber> subscribers_;
  ros::ServiceServer global_;
  ros::Timer timer_;
  std::unique_ptr<ServiceCaller> writer_ = std::make_unique<ServiceCaller>();
};

}  // namespace
}  // namespace coppice::robot::localization

int main(int argc, char** argv) {
  using namespace coppice::robot::localization;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(
      argc, argv, "localization", kHelp, [](Settings& settings) {
        if (!settings.start && !coppice::robot::ReadHome(settings.places, settings.start)) return 2;
        LocalizationNode node(settings);
        ros::spin();
        node.LeavePose();
        return 0;
      });
}
