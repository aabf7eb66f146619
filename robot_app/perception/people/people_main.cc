// coppice-people: the ROS node that sees people and follows them.
#include <coppice_msgs/People.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "robot_app/common/ros_support.h"
#include "robot_app/perception/clouds/hidden.h"
#include "robot_app/perception/clouds/people_finder.h"
#include "robot_app/perception/people/cloud_decoder.h"
#include "robot_app/perception/people/people_messages.h"
#include "robot_app/perception/tracking/tracker.h"

namespace coppice::robot::perception {
namespace {

constexpr char kHelp[] =
    "coppice-people: finds people in clouds of the 3-D lidar and follows them, as the ROS node\n"
    "/people_tracker.\n"
    "  subscribes  /velodyne_points /tf /tf_static (of the lidar)\n"
    "  publishes   /people (coppice_msgs/People), /people/markers (for RViz), /diagnostics\n";

constexpr double kPeriod = 0.1;     // of a turn of the lidar [s]
constexpr double kStatePeriod = 1;  // wall time [s]
constexpr double kSilence = 2;      // without a cloud: an error; wall time [s]
constexpr double kLowest = 0.2;     // the lidar is at least so high above the floor [m]
constexpr double kHighest = 3;      // and at most [m]

constexpr char kShipped[] = "shipped";

struct Settings {
  std::string classifier = kShipped;
  std::string frame = "odom";
  double least_probability = 0.5;
  double farthest = 20;
};

Parameters ParametersOf(Settings& settings) {
  return {{"classifier", &settings.classifier, "a file that coppice-train made"},
          {"frame", &settings.frame, "in which people are followed; it must not move"},
          {"least_probability", &settings.least_probability, 0.05, 0.99,
           "from which a cluster is a person"},
          {"farthest", &settings.farthest, 1, 50, "people are looked for so far [m]"}};
}

// Times behind it cannot be calculated with: ros::Time throws where it overflows.
const ros::Time kLatest(0xFFFFFFF0, 0);

// The lidar in the frame in which people are followed.
struct Mount {
  Eigen::Vector2d place{0, 0};
  double yaw = 0;
  double height = 0;

  Eigen::Vector2d ToFrame(const Eigen::Vector2d& seen) const {
    return Eigen::Rotation2Dd(yaw) * seen + place;
  }
  Eigen::Vector2d ToLidar(const Eigen::Vector2d& at) const {
    return Eigen::Rotation2Dd(-yaw) * (at - place);
  }
};

class PeopleNode {
 public:
  PeopleNode(const Settings& settings, PersonClassifier classifier)
      : settings_(settings), classifier_(std::move(classifier)) {
    people_ = node_.advertise<coppice_msgs::People>("/people", 5);
    markers_ = node_.advertise<visualization_msgs::MarkerArray>("/people/markers", 2);
    diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 5);
    // Of clouds that wait only the newest one counts.
    subscriber_ = node_.subscribe<sensor_msgs::PointCloud2>(
        "/velodyne_points", 1,
        [this](const sensor_msgs::PointCloud2::ConstPtr& message) { OnCloud(*message); });
    state_timer_ = node_.createWallTimer(ros::WallDuration(kStatePeriod),
                                         [this](const ros::WallTimerEvent&) { PublishState(); });
  }

 private:
  void OnCloud(const sensor_msgs::PointCloud2& message) {
    const auto begin = std::chrono::steady_clock::now();
    last_cloud_ = ros::WallTime::now();
    const Outcome done = Follow(message);
    problem_ = done.problem();
    if (!done) return;
    ++clouds_;
    calculated_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  Outcome Follow(const sensor_msgs::PointCloud2& message) {
    if (message.header.stamp > kLatest) return Problem{"the cloud comes from the far future"};
    if (const Outcome decoded = Decode(message, points_); !decoded) return decoded;
    const auto mount = MountAt(message.header.frame_id, message.header.stamp);
    if (!mount) return Problem{mount.problem()};
    PeopleFinder& finder = FinderAt(mount->height);
    std::vector<Detection> detections;
    for (const SeenPerson& person : finder.Find(points_)) {
      // The robot may have turned since the turn of the lidar began.
      const ros::Time met = message.header.stamp + ros::Duration(person.turn * kPeriod);
      const auto then = MountAt(message.header.frame_id, met);
      detections.push_back(ToDetection(person, then ? *then : *mount));
    }
    const double now = (message.header.stamp + ros::Duration(kPeriod / 2)).toSec();
    tracker_.Update(now, detections, [&](const Eigen::Vector2d& at) {
      return IsHidden(finder.candidates().image(), mount->ToLidar(at).cast<float>());
    });
    const coppice_msgs::People people = ToMessage(tracker_, settings_.frame);
    people_.publish(people);
    if (markers_.getNumSubscribers() > 0) markers_.publish(ToMarkers(people));
    return {};
  }

  static Detection ToDetection(const SeenPerson& person, const Mount& mount) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(mount.yaw).toRotationMatrix();
    Detection detection;
    detection.position = mount.ToFrame(person.position.cast<double>());
    detection.covariance = turn * person.covariance.cast<double>() * turn.transpose();
    detection.probability = person.probability;
    return detection;
  }

  // At that time, or the newest that is known.
  Expected<Mount> MountAt(const std::string& lidar, const ros::Time& time) {
    auto found = transforms_.Find(settings_.frame, lidar, time);
    if (!found) found = transforms_.Find(settings_.frame, lidar, ros::Time(0));
    if (!found) return Problem{found.problem()};
    const geometry_msgs::Transform& transform = found->transform;
    const double height = transform.translation.z;
    if (!(height >= kLowest && height <= kHighest)) {
      return Problem{"the lidar " + lidar + " is " + std::to_string(height) + " m above " +
                     settings_.frame + ", expected 0.2 to 3"};
    }
    return Mount{
        {transform.translation.x, transform.translation.y}, YawOf(transform.rotation), height};
  }

  PeopleFinder& FinderAt(double height) {
    if (finder_) return *finder_;
    FinderOptions options;
    options.candidates.geometry.height = static_cast<float>(height);
    options.least_probability = static_cast<float>(settings_.least_probability);
    options.farthest = static_cast<float>(settings_.farthest);
    return finder_.emplace(options, std::move(classifier_));
  }

  void PublishState() {
    const double silence = (ros::WallTime::now() - last_cloud_).toSec();
    diagnostic_msgs::DiagnosticStatus status;
    status.name = "people: clouds";
    status.level = diagnostic_msgs::DiagnosticStatus::OK;
    status.message = "looking for people";
    if (silence > kSilence) {
      status.level = diagnostic_msgs::DiagnosticStatus::ERROR;
      status.message = "no clouds on " + subscriber_.getTopic();
    } else if (!problem_.empty()) {
      status.level = diagnostic_msgs::DiagnosticStatus::ERROR;
      status.message = problem_;
    }
    const auto add = [&status](const char* key, const std::string& value) {
      status.values.emplace_back();
      status.values.back().key = key;
      status.values.back().value = value;
    };
    add("people",
        std::to_string(std::count_if(tracker_.tracks().begin(), tracker_.tracks().end(),
                                     [](const Track& track) { return track.is_confirmed; })));
    add("clouds", std::to_string(clouds_));
    add("per cloud [ms]", std::to_string(clouds_ > 0 ? 1e3 * calculated_ / clouds_ : 0));
    diagnostic_msgs::DiagnosticArray message;
    message.header.stamp = ros::Time::now();
    message.status.push_back(status);
    diagnostics_.publish(message);
  }

  const Settings settings_;
  PersonClassifier classifier_;  // until the finder has it
  ros::NodeHandle node_;
  Transforms transforms_;
  std::optional<PeopleFinder> finder_;  // once the height of the lidar is known
  Tracker tracker_;
  std::vector<LidarPoint> points_;
  std::string problem_;  // of the last cloud
  ros::WallTime last_cloud_ = ros::WallTime::now();
  std::uint64_t clouds_ = 0;
  double calculated_ = 0;  // s, for all of them
  ros::Publisher people_, markers_, diagnostics_;
  ros::Subscriber subscriber_;
  ros::WallTimer state_timer_;
};

int Main(int argc, char** argv) {
  Settings settings;
  const Parameters parameters = ParametersOf(settings);
  if (const auto exit = StartNode(argc, argv, "people_tracker", kHelp, parameters)) return *exit;
  const bool is_shipped = settings.classifier == kShipped;
  auto classifier = PersonClassifier::Load(is_shipped ? COPPICE_CLASSIFIER : settings.classifier);
  if (!classifier) {
    ROS_ERROR("%s", classifier.problem().c_str());
    return 1;
  }
  const PeopleNode node(settings, std::move(*classifier));
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::perception

int main(int argc, char** argv) { return coppice::robot::perception::Main(argc, argv); }
