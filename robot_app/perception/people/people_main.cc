// coppice-people: the ROS node that sees people and follows them.
#include <coppice_msgs/People.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/common/ros_support.h"
#include "robot_app/common/shipped.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/perception/people/people_follower.h"
#include "robot_app/perception/people/people_messages.h"
#include "robot_app/perception/people/record_command.h"

namespace coppice::robot::perception {
namespace {

constexpr char kHelp[] =
    "coppice-people: finds people in clouds of the 3-D lidar, joins them with those whom\n"
    "coppice-camera sees in pictures, and follows them, as the ROS node /people_tracker.\n"
    "While there are no clouds, it finds them by their legs in scans of the planar laser.\n"
    "  subscribes  /velodyne_points /people/sightings /scan /tf /tf_static (of lidar and laser)\n"
    "  publishes   /people (coppice_msgs/People), /people/markers (for RViz), /diagnostics\n"
    "coppice-people --offline FILE.bag: who was there in a record; --offline --help says more.\n";

constexpr double kStatePeriod = 1;  // wall time [s]
constexpr double kSilence = 2;      // without a cloud: an error; wall time [s]
constexpr double kNoPicture = 2;    // after the last one: none comes too late any more; the same

constexpr char kShipped[] = "shipped";

struct Settings {
  std::string classifier = kShipped;
  std::string leg_classifier = kShipped;
  bool cameras = true;
  bool laser = true;
  FollowerOptions following;
};

Parameters ParametersOf(Settings& settings) {
  FollowerOptions& following = settings.following;
  return {{"classifier", &settings.classifier, "a file that coppice-train made"},
          {"leg_classifier", &settings.leg_classifier, "the same for scans of the laser"},
          {"frame", &following.frame, "in which people are followed; it must not move"},
          {"least_probability", &following.least_probability, 0.05, 0.99,
           "from which a cluster is a person"},
          {"farthest", &following.farthest, 1, 50, "people are looked for so far [m]"},
          {"cameras", &settings.cameras, "joins what coppice-camera sees"},
          {"laser", &settings.laser, "looks for legs while there are no clouds"}};
}

class PeopleNode {
 public:
  PeopleNode(const Settings& settings, Classifiers classifiers)
      : settings_(settings),
        follower_(settings.following, std::move(classifiers),
                  [this](const std::string& parent, const std::string& child,
                         const ros::Time& time) { return transforms_.Find(parent, child, time); }) {
    people_ = node_.advertise<coppice_msgs::People>("/people", 5);
    markers_ = node_.advertise<visualization_msgs::MarkerArray>("/people/markers", 2);
    diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 5);
    // Of clouds that wait only the newest one counts.
    clouds_subscriber_ = node_.subscribe<sensor_msgs::PointCloud2>(
        "/velodyne_points", 1,
        [this](const sensor_msgs::PointCloud2::ConstPtr& message) { OnCloud(*message); });
    if (settings_.cameras) {
      sightings_subscriber_ = node_.subscribe<coppice_msgs::Sightings>(
          "/people/sightings", 4,
          [this](const coppice_msgs::Sightings::ConstPtr& message) { OnSightings(*message); });
    }
    if (settings_.laser) {
      scans_subscriber_ = node_.subscribe<sensor_msgs::LaserScan>(
          "/scan", 1,
          [this](const sensor_msgs::LaserScan::ConstPtr& message) { OnScan(*message); });
    }
    state_timer_ = node_.createWallTimer(ros::WallDuration(kStatePeriod),
                                         [this](const ros::WallTimerEvent&) { PublishState(); });
  }

 private:
  void OnCloud(const sensor_msgs::PointCloud2& message) {
    const auto begin = std::chrono::steady_clock::now();
    last_cloud_ = ros::WallTime::now();
    Outcome done = CheckStamp(message.header.stamp, ros::Time::now());
    if (done) done = follower_.OnCloud(message);
    problem_ = done.problem();
    if (!done) return;
    Publish();
    ++clouds_;
    calculated_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  void OnSightings(const coppice_msgs::Sightings& message) {
    const Outcome checked = CheckStamp(message.header.stamp, ros::Time::now());
    sightings_problem_ = checked.problem();
    if (!checked) return;
    const auto late = follower_.OnSightings(message);
    sightings_problem_ = late.problem();
    if (!late) return;
    last_picture_ = ros::WallTime::now();
    late_picture_ = *late > kMostDelay ? Late(message.camera, *late) : "";
    ++(*late > kMostDelay ? late_pictures_ : pictures_);
    // The lidar gives the beat, as long as there is one.
    if (SilenceOfLidar() > kSilence) Publish();
  }

  void OnScan(const sensor_msgs::LaserScan& message) {
    const Outcome checked = CheckStamp(message.header.stamp, ros::Time::now());
    scan_problem_ = checked.problem();
    if (!checked) return;
    const auto looked = follower_.OnScan(message);
    scan_problem_ = looked.problem();
    if (!looked || !*looked) return;
    ++scans_;
    Publish();
  }

  void Publish() {
    const coppice_msgs::People people = ToMessage(follower_.tracker(), settings_.following.frame);
    people_.publish(people);
    if (markers_.getNumSubscribers() > 0) markers_.publish(ToMarkers(people));
  }

  static std::string Late(const std::string& camera, double late) {
    char text[120];
    std::snprintf(
        text, sizeof(text),
        "what the camera %.20s sees comes %.1f s late, up to %g s count: the computer has "
        "too much to do",
        camera.c_str(), late, kMostDelay);
    return text;
  }

  double SilenceOfLidar() const { return (ros::WallTime::now() - last_cloud_).toSec(); }

  // What is wrong; empty: nothing.
  std::string Complaint() const {
    if (SilenceOfLidar() > kSilence) return "no clouds on " + clouds_subscriber_.getTopic();
    if (!problem_.empty()) return problem_;
    return !sightings_problem_.empty() ? sightings_problem_ : scan_problem_;
  }

  void PublishState() {
    using diagnostic_msgs::DiagnosticStatus;
    DiagnosticStatus status;
    status.name = "people: clouds";
    status.level = DiagnosticStatus::OK;
    status.message = "looking for people";
    if (!late_picture_.empty() && (ros::WallTime::now() - last_picture_).toSec() < kNoPicture) {
      status.level = DiagnosticStatus::WARN;
      status.message = late_picture_;
    }
    if (const std::string problem = Complaint(); !problem.empty()) {
      status.level = DiagnosticStatus::ERROR;
      status.message = problem;
    }
    const auto add = [&status](const char* key, const std::string& value) {
      status.values.emplace_back();
      status.values.back().key = key;
      status.values.back().value = value;
    };
    const std::vector<Track>& tracks = follower_.tracker().tracks();
    add("people", std::to_string(std::count_if(tracks.begin(), tracks.end(),
                                               [](const Track& one) { return one.is_confirmed; })));
    add("clouds", std::to_string(clouds_));
    add("pictures", std::to_string(pictures_));
    add("late pictures", std::to_string(late_pictures_));
    add("scans", std::to_string(scans_));
    add("per cloud [ms]", std::to_string(clouds_ > 0 ? 1e3 * calculated_ / clouds_ : 0));
    diagnostic_msgs::DiagnosticArray message;
    message.header.stamp = ros::Time::now();
    message.status.push_back(status);
    diagnostics_.publish(message);
  }

  const Settings settings_;
  ros::NodeHandle node_;
  Transforms transforms_;
  PeopleFollower follower_;
  std::string problem_;            // of the last cloud
  std::string sightings_problem_;  // of the last sightings
  std::string scan_problem_;       // of the last scan
  ros::WallTime last_cloud_ = ros::WallTime::now();
  std::uint64_t clouds_ = 0, pictures_ = 0, scans_ = 0;  // that were looked at
  std::string late_picture_;                             // about the last one, if it was too late
  ros::WallTime last_picture_;
  std::uint64_t late_pictures_ = 0;
  double calculated_ = 0;  // s, for all clouds
  ros::Publisher people_, markers_, diagnostics_;
  ros::Subscriber clouds_subscriber_, sightings_subscriber_, scans_subscriber_;
  ros::WallTimer state_timer_;
};

std::string FileOf(const std::string& setting, const char* shipped) {
  return setting == kShipped ? Shipped(shipped) : setting;
}

int Run(const Settings& settings) {
  auto classifiers = Classifiers::Load(FileOf(settings.classifier, COPPICE_CLASSIFIER),
                                       FileOf(settings.leg_classifier, COPPICE_LEGS));
  if (!classifiers) {
    ROS_ERROR("%s", classifiers.problem().c_str());
    return 1;
  }
  const PeopleNode node(settings, std::move(*classifiers));
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::perception

int main(int argc, char** argv) {
  using namespace coppice::robot::perception;  // NOLINT: the whole program
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (IsAboutRecord(arguments))
    return LookIntoRecord(arguments, coppice::robot::Shipped(COPPICE_CLASSIFIER),
                          coppice::robot::Shipped(COPPICE_LEGS));
  return coppice::robot::RunNode<Settings>(argc, argv, "people_tracker", kHelp, Run);
}
