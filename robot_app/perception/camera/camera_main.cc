// coppice-camera: the ROS node that looks for people and faces in the pictures of the RGB-D
// cameras.
#include <coppice_msgs/Sightings.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <chrono>
#include <deque>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "bt_core/base/diagnostic.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/shipped.h"
#include "robot_app/common/transforms/eigen_transform.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/perception/camera/damaged_rows.h"
#include "robot_app/perception/camera/people_in_pictures.h"
#include "robot_app/perception/camera/rgbd_topics.h"
#include "robot_app/perception/people/cloud_decoder.h"
#include "robot_app/perception/people/sighting_messages.h"
#include "robot_app/perception/sightings/depth_turn.h"

namespace coppice::robot::perception {
namespace {

constexpr char kHelp[] =
    "coppice-camera: looks for people and faces in the pictures of the RGB-D cameras, as the ROS\n"
    "node /camera_detector. NAME is a camera: front or rear.\n"
    "  subscribes  /camera/NAME/color/image_raw/compressed (JPEG)\n"
    "              /camera/NAME/color/camera_info\n"
    "              /camera/NAME/aligned_depth_to_color/image_raw/compressedDepth (PNG, mm)\n"
    "              /velodyne_points (how far somebody is), /tf /tf_static\n"
    "              all of them only while somebody subscribes to what it publishes\n"
    "  publishes   /people/sightings (coppice_msgs/Sightings), /diagnostics\n";

constexpr double kStatePeriod = 1;    // wall time [s]
constexpr double kSilence = 2;        // without a picture: an error; wall time [s]
constexpr double kLidarAlive = 1;     // no cloud for longer: it is dead; wall time [s]
constexpr double kSameMoment = 0.15;  // between a picture and the cloud that says how far [s]
constexpr double kTurn = 0.1;         // of the lidar [s]
constexpr char kShipped[] = "shipped";

struct Settings {
  std::string cameras = "front rear";
  double period = 0.5;
  double depth_period = 0.2;
  std::string frame = "odom";
  std::string depth_classifier = kShipped;
  std::string mask_classifier = kShipped;
  bool lidar = true;
  DetectorChoice detectors;
};

Parameters ParametersOf(Settings& settings) {
  DetectorChoice& choice = settings.detectors;
  return {
      {"cameras", &settings.cameras, "front, rear or both"},
      {"period", &settings.period, 0.05, 10, "between two pictures; wall time [s]"},
      {"depth_period", &settings.depth_period, 0.05, 10,
       "between looks at depth alone; wall time [s]"},
      {"frame", &settings.frame, "in which places are told; it must not move"},
      {"detectors", &choice.built_in, "some of people, faces and masks"},
      {"cascade", &choice.cascade_file, "for faces; else that of Debian's opencv-data"},
      {"mask_classifier", &settings.mask_classifier, "for masks: a file that coppice-train made"},
      {"network", &choice.network.file, "Darknet's .weights, or .onnx"},
      {"network_config", &choice.network.config, "the .cfg of Darknet's .weights"},
      {"network_classes", &choice.network.classes, "a name a line; else COCO, or people alone"},
      {"network_size", &choice.network.size, 0, 4096,
       "of its square [pixels]; 0: as it says itself"},
      {"least_confidence", &choice.least_confidence, 0.05, 0.99, "from which something is seen"},
      {"depth_classifier", &settings.depth_classifier, "for people in depth; none: only in colour"},
      {"lidar", &settings.lidar, "its points too say how far somebody is"},
  };
}

// One camera with what looks at its pictures.
struct Eye {
  Eye(ros::NodeHandle& node, const std::string& name, Detector& detector,
      std::optional<PersonClassifier> classifier, const std::function<void(Eye&)>& changed)
      : topics(node, name, [this, changed] { changed(*this); }),
        people(detector, std::move(classifier)) {}

  RgbdTopics topics;
  PeopleInPictures people;
  TornGauge damage;
  ros::WallTime due;          // the next picture
  ros::WallTime depth_due;    // the next look at the depth alone
  std::string problem;        // of the last picture
  std::string depth_problem;  // of the last look at the depth alone
  std::uint64_t pictures = 0;
  double calculated = 0;  // s, for all of them
};

class CameraNode {
 public:
  CameraNode(const Settings& settings, std::unique_ptr<Detector> detector)
      : settings_(settings), detector_(std::move(detector)) {
    const ros::SubscriberStatusCallback changed = [this](const ros::SingleSubscriberPublisher&) {
      Listen();
    };
    sightings_ = node_.advertise<coppice_msgs::Sightings>("/people/sightings", 4, changed, changed);
    diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 5);
    state_timer_ = node_.createWallTimer(ros::WallDuration(kStatePeriod),
                                         [this](const ros::WallTimerEvent&) { PublishState(); });
  }

  void Add(const std::string& name, std::optional<PersonClassifier> classifier) {
    eyes_.emplace_back(node_, name, *detector_, std::move(classifier),
                       [this](Eye& eye) { OnMessage(eye); });
  }

 private:
  // Nobody draws, sends or decodes a picture that nobody asks for.
  void Listen() {
    const bool is_on = sightings_.getNumSubscribers() > 0;
    for (Eye& eye : eyes_) eye.topics.SetOn(is_on);
    if (!is_on || !settings_.lidar) {
      cloud_subscriber_ = ros::Subscriber();
      cloud_.reset();
    } else if (!cloud_subscriber_) {
      using sensor_msgs::PointCloud2;
      cloud_subscriber_ =
          node_.subscribe<PointCloud2>("/velodyne_points", 1,
                                       boost::function<void(const PointCloud2::ConstPtr&)>(
                                           [this](const PointCloud2::ConstPtr& cloud) {
                                             if (!StampOfNow(cloud->header, "/velodyne_points"))
                                               return;
                                             cloud_ = cloud;
                                             last_cloud_ = ros::WallTime::now();
                                           }));
    }
  }

  void OnMessage(Eye& eye) {
    const ros::WallTime now = ros::WallTime::now();
    const bool is_overdue = now > eye.due + ros::WallDuration(settings_.period / 2);
    if (now >= eye.due && eye.topics.HasMoment(is_overdue)) {
      eye.due = NextAfter(eye.due, settings_.period, now);
      eye.depth_due = now + ros::WallDuration(settings_.depth_period);
      eye.depth_problem.clear();
      eye.problem = Counted(eye, now, Look(eye));
    } else if (IsAloneWithDepth(eye, now)) {
      eye.depth_due = NextAfter(eye.depth_due, settings_.depth_period, now);
      eye.depth_problem = Counted(eye, now, LookAtDepth(eye));
    }
  }

  static ros::WallTime NextAfter(ros::WallTime due, double period, ros::WallTime now) {
    return std::max(due + ros::WallDuration(period), now + ros::WallDuration(period / 2));
  }

  // Only the cameras see people now. A picture in colour that is due has the depth with it.
  bool IsAloneWithDepth(const Eye& eye, ros::WallTime now) const {
    const bool has_lidar = settings_.lidar && (now - last_cloud_).toSec() < kLidarAlive;
    return !has_lidar && now < eye.due && now >= eye.depth_due && eye.topics.HasDepth();
  }

  // The problem, if there is one.
  static std::string Counted(Eye& eye, ros::WallTime begin, const Outcome& done) {
    if (!done) return done.problem();
    ++eye.pictures;
    eye.calculated += (ros::WallTime::now() - begin).toSec();
    return "";
  }

  Outcome Look(Eye& eye) {
    Expected<RgbdMoment> moment = eye.topics.Take();
    if (!moment) return Problem{moment.problem()};
    if (IsCovered(moment->colour, moment->depth)) {
      return Problem{"the picture shows nothing: is the lens covered?"};
    }
    eye.damage.Add(moment->colour, moment->depth);
    auto ranges = RangesOf(*moment);
    if (!ranges) return Problem{ranges.problem()};
    Outcome cloud = AddLidar(moment->header.stamp, *ranges);
    Publish(eye, *moment, *ranges, eye.people.Find(moment->colour, *ranges));
    return cloud;
  }

  Outcome LookAtDepth(Eye& eye) {
    Expected<RgbdMoment> moment = eye.topics.TakeDepth();
    if (!moment) return Problem{moment.problem()};
    auto ranges = RangesOf(*moment);
    if (!ranges) return Problem{ranges.problem()};
    Publish(eye, *moment, *ranges, eye.people.FindInDepth(*ranges));
    return {};
  }

  // Takes the depth out of the moment.
  Expected<Ranges> RangesOf(RgbdMoment& moment) {
    const std_msgs::Header& header = moment.header;
    if (Outcome now = CheckStamp(header.stamp, ros::Time::now()); !now) {
      return Problem{"a picture is not used: " + now.problem()};
    }
    const auto optical = PoseOf(header.frame_id, header.stamp);
    if (!optical) return Problem{optical.problem()};
    Ranges ranges;
    ranges.lens = moment.lens;
    ranges.depth = std::move(moment.depth);
    ranges.optical_in_frame = *optical;
    return ranges;
  }

  void Publish(const Eye& eye, const RgbdMoment& moment, const Ranges& ranges,
               const std::vector<PlacedSighting>& seen) {
    const bool in_colour = moment.colour.width > 0;
    const int width = in_colour ? moment.colour.width : ranges.depth.width;
    const int height = in_colour ? moment.colour.height : ranges.depth.height;
    coppice_msgs::Sightings message;
    message.header.stamp = moment.header.stamp;
    message.header.frame_id = settings_.frame;
    message.camera = eye.topics.name();
    message.width = static_cast<std::uint32_t>(width);
    message.height = static_cast<std::uint32_t>(height);
    const Eigen::Vector3d forward = ranges.optical_in_frame.linear().col(2);
    message.lens.x = ranges.optical_in_frame.translation().x();
    message.lens.y = ranges.optical_in_frame.translation().y();
    message.lens.theta = std::atan2(forward.y(), forward.x());
    message.half_angle = static_cast<float>(HalfAngle(ranges.lens, width));
    message.farthest = ranges.depth.width > 0 ? static_cast<float>(kFarthestDepth) : 0;
    for (const PlacedSighting& placed : seen) message.sightings.push_back(ToMessage(placed));
    sightings_.publish(message);
  }

  // At that time, or the newest that is known.
  Expected<Eigen::Isometry3d> PoseOf(const std::string& child, const ros::Time& time) {
    auto found = transforms_.Find(settings_.frame, child, time);
    if (!found) found = transforms_.Find(settings_.frame, child, ros::Time(0));
    if (!found) return Problem{found.problem()};
    return ToEigen(found->transform);
  }

  // The lidar's points as the camera would see them, if there are some of that time.
  Outcome AddLidar(const ros::Time& time, Ranges& ranges) {
    if (!cloud_) return {};
    const double age = time.toSec() - cloud_->header.stamp.toSec() - kTurn / 2;
    if (std::abs(age) > kSameMoment) return {};
    if (Outcome decoded = Decode(*cloud_, points_); !decoded) return decoded;
    const auto lidar =
        PoseOf(cloud_->header.frame_id, cloud_->header.stamp + ros::Duration(kTurn / 2));
    if (!lidar) return Problem{lidar.problem()};
    const Eigen::Isometry3f in_optical = (ranges.optical_in_frame.inverse() * *lidar).cast<float>();
    for (const LidarPoint& point : points_) {
      const Eigen::Vector3f seen = in_optical * Eigen::Vector3f(point.x, point.y, point.z);
      if (seen.z() > 0) ranges.lidar.push_back(seen);
    }
    return {};
  }

  diagnostic_msgs::DiagnosticStatus StateOf(const Eye& eye) const {
    diagnostic_msgs::DiagnosticStatus status;
    status.name = "camera: " + eye.topics.name();
    status.level = diagnostic_msgs::DiagnosticStatus::OK;
    status.message = eye.topics.is_on() ? "looking for people" : "nobody asks";
    const double silence = (ros::WallTime::now() - eye.topics.last_picture()).toSec();
    if (eye.topics.is_on() && silence > kSilence) {
      status.level = diagnostic_msgs::DiagnosticStatus::ERROR;
      status.message = "no pictures of camera " + eye.topics.name();
    } else if (eye.topics.is_on() && !(eye.problem + eye.depth_problem).empty()) {
      status.level = diagnostic_msgs::DiagnosticStatus::ERROR;
      status.message = !eye.problem.empty() ? eye.problem : eye.depth_problem;
    } else if (eye.topics.is_on() && eye.damage.is_damaged()) {
      status.level = diagnostic_msgs::DiagnosticStatus::WARN;
      status.message = "rows of its pictures do not fit together: is the cable damaged?";
    }
    const auto add = [&status](const char* key, const std::string& value) {
      status.values.emplace_back();
      status.values.back().key = key;
      status.values.back().value = value;
    };
    add("pictures", std::to_string(eye.pictures));
    const auto count = static_cast<double>(std::max<std::uint64_t>(eye.pictures, 1));
    add("rows that do not fit [%]", std::to_string(100 * eye.damage.share()));
    add("per picture [ms]", std::to_string(1e3 * eye.calculated / count));
    return status;
  }

  void PublishState() {
    diagnostic_msgs::DiagnosticArray message;
    message.header.stamp = ros::Time::now();
    for (const Eye& eye : eyes_) message.status.push_back(StateOf(eye));
    diagnostics_.publish(message);
  }

  const Settings settings_;
  std::unique_ptr<Detector> detector_;
  ros::NodeHandle node_;
  Transforms transforms_;
  std::deque<Eye> eyes_;                      // they stay where they are
  sensor_msgs::PointCloud2::ConstPtr cloud_;  // the newest one
  ros::WallTime last_cloud_;
  std::vector<LidarPoint> points_;
  ros::Subscriber cloud_subscriber_;
  ros::Publisher sightings_, diagnostics_;
  ros::WallTimer state_timer_;
};

int Refuse(const std::string& problem) {
  ROS_ERROR("%s", problem.c_str());
  return 1;
}

Expected<std::vector<std::string>> NamesIn(const std::string& cameras) {
  std::vector<std::string> names;
  std::istringstream words(cameras);
  for (std::string name; words >> name;) {
    if (name != "front" && name != "rear") {
      return Problem{"there is no camera \"" + name + "\"" + DidYouMean(name, {"front", "rear"}) +
                     "; expected front, rear or both"};
    }
    names.push_back(name);
  }
  if (names.empty()) return Problem{"expected one of the cameras front and rear"};
  return names;
}

DetectorChoice ChoiceOf(const Settings& settings) {
  DetectorChoice choice = settings.detectors;
  const bool is_shipped = settings.mask_classifier == kShipped;
  choice.mask_file = is_shipped ? Shipped(COPPICE_MASKS) : settings.mask_classifier;
  return choice;
}

int Main(int argc, char** argv) {
  Settings settings;
  settings.detectors.built_in = "people masks";
  const Parameters parameters = ParametersOf(settings);
  if (const auto exit = StartNode(argc, argv, "camera_detector", kHelp, parameters)) return *exit;
  const auto names = NamesIn(settings.cameras);
  if (!names) return Refuse(names.problem());
  auto detector = MakeDetector(ChoiceOf(settings));
  if (!detector) return Refuse(detector.problem());
  CameraNode node(settings, std::move(*detector));
  for (const std::string& name : *names) {
    std::optional<PersonClassifier> classifier;
    if (settings.depth_classifier != "none") {
      const bool is_shipped = settings.depth_classifier == kShipped;
      auto loaded = PersonClassifier::Load(is_shipped ? Shipped(COPPICE_CLASSIFIER)
                                                      : settings.depth_classifier);
      if (!loaded) return Refuse(loaded.problem());
      classifier.emplace(std::move(*loaded));
    }
    node.Add(name, std::move(classifier));
  }
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::perception

int main(int argc, char** argv) { return coppice::robot::perception::Main(argc, argv); }
