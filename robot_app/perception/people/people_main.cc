// coppice-people: the ROS node that sees people and follows them.
#include <coppice_msgs/People.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/common/ros_support.h"
#include "robot_app/perception/people/people_follower.h"
#include "robot_app/perception/people/people_messages.h"
#include "robot_app/perception/people/record_command.h"

namespace coppice::robot::perception {
namespace {

constexpr char kHelp[] =
    "coppice-people: finds people in clouds of the 3-D lidar, joins them with those whom\n"
    "coppice-camera sees in pictures, and follows them, as the ROS node /people_tracker.\n"
    "  subscribes  /velodyne_points /people/sightings /tf /tf_static (of the lidar)\n"
    "  publishes   /people (coppice_msgs/People), /people/markers (for RViz), /diagnostics\n"
    "coppice-people --offline FILE.bag: who was there in a record; --offline --help says more.\n";

constexpr double kStatePeriod = 1;  // wall time [s]
constexpr double kSilence = 2;      // without a cloud: an error; wall time [s]

constexpr char kShipped[] = "shipped";

struct Settings {
  std::string classifier = kShipped;
  bool cameras = true;
  FollowerOptions following;
};

Parameters ParametersOf(Settings& settings) {
  FollowerOptions& following = settings.following;
  return {{"classifier", &settings.classifier, "a file that coppice-train made"},
          {"frame", &following.frame, "in which people are followed; it must not move"},
          {"least_probability", &following.least_probability, 0.05, 0.99,
           "from which a cluster is a person"},
          {"farthest", &following.farthest, 1, 50, "people are looked for so far [m]"},
          {"cameras", &settings.cameras, "joins what coppice-camera sees"}};
}

class PeopleNode {
 public:
  PeopleNode(const Settings& settings, PersonClassifier classifier)
      : settings_(settings),
        follower_(settings.following, std::move(classifier),
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
    state_timer_ = node_.createWallTimer(ros::WallDuration(kStatePeriod),
                                         [this](const ros::WallTimerEvent&) { PublishState(); });
  }

 private:
  void OnCloud(const sensor_msgs::PointCloud2& message) {
    const auto begin = std::chrono::steady_clock::now();
    last_cloud_ = ros::WallTime::now();
    const Outcome done = follower_.OnCloud(message);
    problem_ = done.problem();
    if (!done) return;
    Publish();
    ++clouds_;
    calculated_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  void OnSightings(const coppice_msgs::Sightings& message) {
    const Outcome done = follower_.OnSightings(message);
    sightings_problem_ = done.problem();
    if (!done) return;
    ++pictures_;
    // The lidar gives the beat, as long as there is one.
    if (SilenceOfLidar() > kSilence) Publish();
  }

  void Publish() {
    const coppice_msgs::People people = ToMessage(follower_.tracker(), settings_.following.frame);
    people_.publish(people);
    if (markers_.getNumSubscribers() > 0) markers_.publish(ToMarkers(people));
  }

  double SilenceOfLidar() const { return (ros::WallTime::now() - last_cloud_).toSec(); }

  // What is wrong; empty: nothing.
  std::string Complaint() const {
    if (SilenceOfLidar() > kSilence) return "no clouds on " + clouds_subscriber_.getTopic();
    return !problem_.empty() ? problem_ : sightings_problem_;
  }

  void PublishState() {
    using diagnostic_msgs::DiagnosticStatus;
    const std::string problem = Complaint();
    DiagnosticStatus status;
    status.name = "people: clouds";
    status.level = problem.empty() ? DiagnosticStatus::OK : DiagnosticStatus::ERROR;
    status.message = problem.empty() ? "looking for people" : problem;
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
  ros::WallTime last_cloud_ = ros::WallTime::now();
  std::uint64_t clouds_ = 0, pictures_ = 0;
  double calculated_ = 0;  // s, for all clouds
  ros::Publisher people_, markers_, diagnostics_;
  ros::Subscriber clouds_subscriber_, sightings_subscriber_;
  ros::WallTimer state_timer_;
};

int Run(const Settings& settings) {
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

int main(int argc, char** argv) {
  using namespace coppice::robot::perception;  // NOLINT: the whole program
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (IsAboutRecord(arguments)) return LookIntoRecord(arguments, COPPICE_CLASSIFIER);
  return coppice::robot::RunNode<Settings>(argc, argv, "people_tracker", kHelp, Run);
}
