// coppice-slam: the mapper of this folder as the ROS node /slam.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "robot_app/common/ros_support.h"
#include "robot_app/common/shipped.h"
#include "robot_app/common/transforms/eigen_transform.h"
#include "robot_app/common/transforms/message_time.h"
#include "robot_app/localization/pose_history.h"
#include "robot_app/mapping/map_message.h"
#include "robot_app/perception/camera/rgbd_topics.h"
#include "robot_app/perception/people/cloud_decoder.h"
#include "robot_app/slam/graph/floor_pose.h"
#include "robot_app/slam/graph_message.h"
#include "robot_app/slam/localization_link.h"
#include "robot_app/slam/map/map_folder.h"
#include "robot_app/slam/map/navigation_frame.h"
#include "robot_app/slam/map/slam_map_file.h"
#include "robot_app/slam/map/slam_mapper.h"
#include "robot_app/slam/map/voxel_drawing.h"
#include "robot_app/slam/straightened_cloud.h"

namespace coppice::robot::slam {
namespace {

constexpr char kHelp[] =
    "coppice-slam: makes a map in three dimensions over many sessions, knows where the robot is\n"
    "on it, and tells the localization which places it recognizes, as the ROS node /slam.\n"
    "NAME is a camera: front or rear.\n"
    "  subscribes  /odometry/filtered /velodyne_points /tf /tf_static (of the sensors)\n"
    "              /camera/NAME/color/image_raw/compressed /camera/NAME/color/camera_info\n"
    "              /camera/NAME/aligned_depth_to_color/image_raw/compressedDepth\n"
    "              /localization/state /localization/pose (on the map that it navigates on)\n"
    "  publishes   /localization/hint (geometry_msgs/PoseWithCovarianceStamped: a known place)\n"
    "              /slam/pose (geometry_msgs/PoseStamped)\n"
    "              /slam/grid (nav_msgs/OccupancyGrid, latched), /slam/graph (for RViz),\n"
    "              /diagnostics\n"
    "  service     /slam/save (std_srvs/Trigger: the next version of the map in ~map_folder)\n"
    "Poses, grid and graph are given in the frame map once the localization has been sure, else\n"
    "in a frame slam_map of their own. Each start is a new session of the map in ~map_folder. A\n"
    "map is saved at the end, too.\n";

constexpr double kStatePeriod = 1;  // wall time [s]
constexpr double kSilence = 2;      // without a cloud: an error; wall time [s]
constexpr double kSamePlace = 0.3;  // between a cloud and a picture that goes with it [m],
constexpr double kSameTurn = 0.5;   // rad
constexpr double kSweep = 0.1;      // that a turn of the lidar takes [s]
constexpr double kDrawPeriod = 1;   // wall time [s]
constexpr char kShipped[] = "shipped";
constexpr char kNone[] = "none";
constexpr char kFrame[] = "slam_map";
constexpr char kNavigationFrame[] = "map";
constexpr double kFirstPicture = 5;  // so long a session's first key frame waits for all [s]
constexpr double kAskPeriod = 1;     // for places, while the localization is not sure [s]

struct Settings {
  std::string map_folder = kNone;
  std::string session = "session";
  std::string cameras = "front rear";
  std::string surroundings = "auto";
  std::string vocabulary = kShipped;
  std::string classifier = kShipped;
  std::string mapping = "yes";
  double grid_period = 10;
  int working = 2000;
  MapperSettings mapper;

  bool maps() const { return mapping == "yes"; }
};

Parameters ParametersOf(Settings& settings) {
  return {{"map_folder", &settings.map_folder, "with the versions of the map; none: a new one"},
          {"session", &settings.session, "the name of this session"},
          {"mapping", &settings.mapping, "yes, or no: only recognizes places of the map"},
          {"cameras", &settings.cameras, "front, rear or both"},
          {"surroundings", &settings.surroundings, "indoor, hall or outdoor; auto: it judges"},
          {"vocabulary", &settings.vocabulary, "a file of `coppice-train vocabulary`"},
          {"classifier", &settings.classifier, "a file of `coppice-train places`"},
          {"grid_period", &settings.grid_period, 1, 3600, "between grids on /slam/grid [s]"},
          {"working", &settings.working, 10, 1000000, "key frames in the working memory"},
          {"step", &settings.mapper.step, 0.1, 5, "a key frame after so much way [m]"},
          {"turn", &settings.mapper.turn, 0.1, 3, "or after such a turn [rad]"},
          {"resolution", &settings.mapper.resolution, 0.02, 1, "of voxels and grid [m]"}};
}

class SlamNode {
 public:
  SlamNode(const Settings& settings, const Vocabulary& vocabulary,
           const PlaceClassifier& classifier, std::unique_ptr<MapStore> store)
      : settings_(settings), mapper_(vocabulary, classifier, settings.mapper, std::move(store)) {}

  /// Goes on with that map, if it is one, in a new session.
  Outcome Start(SlamMap map) {
    const Outcome resumed = mapper_.Resume(std::move(map));
    if (!resumed) return resumed;
    first_ = first_of_session_ = saved_ = key_frames();
    FindFrame();
    if (settings_.maps()) BeginSession(settings_.session);
    ForceWhatIsAsked();
    pose_ = node_.advertise<geometry_msgs::PoseStamped>("/slam/pose", 5);
    grid_ = node_.advertise<nav_msgs::OccupancyGrid>("/slam/grid", 1, true);
    // Who comes later sees it at once, though the robot stands.
    markers_ = node_.advertise<visualization_msgs::MarkerArray>(
        "/slam/graph", 1, [this](const ros::SingleSubscriberPublisher& viewer) {
          if (key_frames() > 0) viewer.publish(Markers());
        });
    diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 5);
    odometry_subscriber_ = node_.subscribe<nav_msgs::Odometry>(
        "/odometry/filtered", 60,
        [this](const nav_msgs::Odometry::ConstPtr& message) { OnOdometry(*message); });
    clouds_subscriber_ = node_.subscribe<sensor_msgs::PointCloud2>(
        "/velodyne_points", 2, [this](const sensor_msgs::PointCloud2::ConstPtr& message) {
          if (StampOfNow(message->header, "/velodyne_points")) cloud_ = message;
        });
    using Service = std_srvs::Trigger;
    save_ = node_.advertiseService("/slam/save",
                                   boost::function<bool(Service::Request&, Service::Response&)>(
                                       [this](Service::Request&, Service::Response& response) {
                                         response.success = Save(response.message);
                                         return true;
                                       }));
    grid_timer_ = node_.createTimer(ros::Duration(settings_.grid_period),
                                    [this](const ros::TimerEvent&) { PublishGrid(); });
    draw_timer_ = node_.createWallTimer(ros::WallDuration(kDrawPeriod),
                                        [this](const ros::WallTimerEvent&) { DrawSome(); });
    state_timer_ = node_.createWallTimer(ros::WallDuration(kStatePeriod),
                                         [this](const ros::WallTimerEvent&) { PublishState(); });
    std::istringstream names(settings_.cameras);
    for (std::string name; names >> name;) {
      cameras_.push_back(std::make_unique<perception::RgbdTopics>(node_, name, [] {}));
      cameras_.back()->SetOn(true);
    }
    return {};
  }

  // Nothing that was driven for is lost because somebody forgot to save it.
  void KeepWhatIsUnsaved() {
    std::string message;
    if (saved_ != key_frames() && settings_.map_folder != kNone) Save(message);
  }

 private:
  std::size_t key_frames() const { return mapper_.graph().poses().size(); }

  void OnOdometry(const nav_msgs::Odometry& message) {
    const auto stamp = StampOfNow(message.header, "/odometry/filtered");
    if (!stamp || !IsValid(message.pose.pose)) return;
    history_.Add(*stamp, robot::ToPose2D(message.pose.pose));
    if (frame_ != history_.frame()) BeginAnew(", again");
    if (cloud_) UseCloud();
    if (key_frames() == first_of_session_) return;
    PlaceNewest();
    geometry_msgs::PoseStamped pose;
    pose.header.stamp = message.header.stamp;
    pose.header.frame_id = FrameName();
    pose.pose = slam::ToPoseMessage(frame_on_map_.value_or(Pose3::Identity()) *
                                    mapper_.PoseOf(ToPose3(robot::ToPose2D(message.pose.pose))));
    pose_.publish(pose);
  }

  // The odometry was restarted, or somebody has carried the robot: how far it went nobody knows.
  void BeginAnew(const char* why) {
    if (frame_ >= 0 && key_frames() > first_of_session_) {
      BeginSession(settings_.session + why);
    }
    frame_ = history_.frame();
  }

  void BeginSession(const std::string& name) {
    mapper_.BeginSession(name);
    first_of_session_ = key_frames();
    frame_on_map_.reset();
    began_.reset();
  }

  void UseCloud() {
    const double stamp = cloud_->header.stamp.toSec();
    const auto odometry = history_.At(stamp);
    if (!odometry) {
      if (!history_.empty() && stamp < history_.newest()) cloud_.reset();  // too old
      return;
    }
    if (history_.newest() < stamp + kSweep) return;
    const auto cloud = std::move(cloud_);
    cloud_.reset();
    last_cloud_ = ros::WallTime::now();
    Sight sight;
    sight.stamp = stamp;
    sight.odometry = ToPose3(*odometry);
    if (!began_) began_ = stamp;
    const bool is_due = settings_.maps() && mapper_.IsDue(sight.odometry);
    if (is_due ? WaitsForPictures(stamp) : !IsAsked(sight)) return;
    if (is_due) {
      const Outcome decoded = AddCloud(*cloud, sight);
      problem_ = decoded.problem();
      if (!decoded) return;
    }
    for (const auto& camera : cameras_) AddPicture(*camera, sight);
    asked_stamp_ = stamp;
    asked_at_ = sight.odometry;
    sight.place = localization_.PlaceOf(stamp, *odometry);
    if (is_due) {
      AddKeyFrame(sight);
    } else if (const auto known = mapper_.Recognize(sight.pictures)) {
      Tell(stamp, known->key_frame, known->relative);
    }
  }

  // A robot that stands makes no other key frame: the first one must have seen something.
  bool WaitsForPictures(double stamp) {
    const auto has_picture = [](const auto& camera) { return camera->HasMoment(false); };
    if (key_frames() > first_of_session_ ||
        std::all_of(cameras_.begin(), cameras_.end(), has_picture)) {
      waits_since_.reset();
    } else if (!waits_since_) {
      waits_since_ = stamp;
    }
    return waits_since_ && std::abs(stamp - *waits_since_) < kFirstPicture;
  }

  // Whether the localization needs to hear of places though no key frame is due: it is not sure, or
  // has believed none since this session began, and the robot may stand for hours.
  bool IsAsked(const Sight& sight) const {
    if (key_frames() == 0 || !localization_.IsAsked()) return false;
    if (!localization_.is_sure() || localization_.recognized() < *began_) {
      return std::abs(sight.stamp - asked_stamp_) >= kAskPeriod;
    }
    return !settings_.maps() && !IsWithin(asked_at_.inverse() * sight.odometry,
                                          settings_.mapper.step, settings_.mapper.turn);
  }

  static bool IsWithin(const Pose3& moved, double way, double turn) {
    return moved.translation().norm() < way && Eigen::AngleAxisd(moved.linear()).angle() < turn;
  }

  void AddKeyFrame(const Sight& sight) {
    newest_odometry_ = ToPose2D(sight.odometry);
    const ros::WallTime begin = ros::WallTime::now();
    const MapperReport report = mapper_.Add(sight);
    calculated_ += (ros::WallTime::now() - begin).toSec();
    problem_ = report.problem;
    by_picture_ += report.of_picture == Verdict::kBelieved ? 1 : 0;
    by_cloud_ += report.of_cloud == Verdict::kBelieved ? 1 : 0;
    FindFrame();
    if (report.by_picture) Tell(sight.stamp, report.by_picture->from, report.by_picture->relative);
  }

  // A robot that stands makes no other one, though the localization has become sure.
  void PlaceNewest() {
    const auto& newest = mapper_.key_frames().back();
    if (frame_on_map_ || newest == nullptr || newest->place) return;
    const auto place = localization_.PlaceOf(history_.newest(), newest_odometry_);
    if (!place) return;
    problem_ = mapper_.PlaceNewest(*place).problem();
    FindFrame();
  }

  // Where all maps, and the newest key frame's, lie on the navigation's.
  void FindFrame() {
    frames_ = OnNavigationMap(mapper_.graph(), mapper_.key_frames());
    if (!frames_.empty()) frame_on_map_ = frames_.back();
  }
  const char* FrameName() const { return frame_on_map_ ? kNavigationFrame : kFrame; }

  void Tell(double stamp, std::uint32_t key_frame, const Pose3& relative) {
    const auto& frame = frames_[mapper_.graph().sessions()[key_frame]];
    if (!frame) return;
    localization_.Tell(stamp, ToPose2D(*frame * mapper_.graph().poses()[key_frame] * relative));
    ++told_;
  }

  Outcome AddCloud(const sensor_msgs::PointCloud2& message, Sight& sight) {
    const Outcome decoded = perception::Decode(message, points_);
    if (!decoded) return decoded;
    const auto mount = transforms_.Find("base_link", message.header.frame_id, ros::Time(0));
    if (!mount) return Problem{mount.problem()};
    sight.cloud = Straightened(points_, ToEigen(mount->transform), sight.stamp, history_);
    return {};
  }

  // What a camera saw at about that place: a picture may be late. One that does not fit is left
  // out.
  void AddPicture(perception::RgbdTopics& camera, Sight& sight) {
    if (!camera.HasMoment(false)) return;
    const auto moment = camera.Take();
    if (!moment) return;
    const double stamp = moment->header.stamp.toSec();
    const auto odometry = history_.At(stamp);
    const auto mount = transforms_.Find("base_link", moment->header.frame_id, ros::Time(0));
    if (!odometry || !mount) return;
    const Pose3 moved = sight.odometry.inverse() * ToPose3(*odometry);
    if (!IsWithin(moved, kSamePlace, kSameTurn)) return;
    const CameraMount lens{moment->lens, moved * ToEigen(mount->transform)};
    sight.pictures.push_back(SeePicture(moment->colour, moment->depth, lens));
    sight.brightness = BrightnessOf(moment->colour);
  }

  Pose3 FrameOnMap() const { return frame_on_map_.value_or(Pose3::Identity()); }

  void DrawSome() {
    if (key_frames() == first_of_session_) return;
    // What cannot be read the diagnostics say.
    voxels_.DrawSome(mapper_.graph(), FrameOnMap(),
                     [this](std::uint32_t number) { return mapper_.key_frame(number); });
  }

  void PublishGrid() {
    if (key_frames() == first_of_session_) return;
    const auto publish = [grids = grid_, frame = FrameName(),
                          now = ros::Time::now()](const OccupancyGrid& grid) {
      if (grid.frame.size() > 0) grids.publish(mapping::ToMessage(grid, frame, now));
    };
    const bool is_new = voxels_.Show(key_frames(), publish);
    if (is_new && markers_.getNumSubscribers() > 0) markers_.publish(Markers());
  }

  visualization_msgs::MarkerArray Markers() const {
    return MarkersOf(mapper_.graph(), FrameName(), FrameOnMap(), ros::Time::now());
  }

  std::string Complaint() const {
    if ((ros::WallTime::now() - last_cloud_).toSec() > kSilence) {
      return "no clouds on " + clouds_subscriber_.getTopic();
    }
    return problem_;
  }

  std::string Surroundings() {  // "hall (dark)"
    const Environment& environment = mapper_.environment();
    return std::string(NameOf(environment.surroundings())) +
           (environment.is_forced() ? " (forced)" : "") + (environment.is_dark() ? " (dark)" : "");
  }

  // A person may change the parameter while it runs.
  void ForceWhatIsAsked() {
    std::string asked;
    if (!ros::param::getCached("~surroundings", asked) || asked == asked_) return;
    asked_ = asked;
    const auto surroundings = AskedSurroundings(asked);
    if (surroundings) {
      mapper_.environment().Force(*surroundings);
    } else {
      ROS_ERROR("%s", surroundings.problem().c_str());
    }
  }

  void PublishState() {
    using diagnostic_msgs::DiagnosticStatus;
    ForceWhatIsAsked();
    DiagnosticStatus status;
    status.name = "slam: map";
    const std::string complaint = Complaint();
    status.level = complaint.empty() ? DiagnosticStatus::OK : DiagnosticStatus::ERROR;
    status.message = !complaint.empty()   ? complaint
                     : !settings_.maps()  ? "recognizes places"
                     : mapper_.IsJoined() ? "maps: " + Surroundings()
                                          : "maps, no known place yet: " + Surroundings();
    const auto add = [&status](const char* key, const std::string& value) {
      status.values.emplace_back();
      status.values.back().key = key;
      status.values.back().value = value;
    };
    const Environment& environment = mapper_.environment();
    add("surroundings", NameOf(environment.surroundings()));
    add("forced", environment.is_forced() ? "yes" : "no");
    add("dark", environment.is_dark() ? "yes" : "no");
    add("sessions", std::to_string(mapper_.graph().session_count()));
    add("key frames", std::to_string(key_frames()));
    add("working memory", std::to_string(mapper_.memory().working()));
    add("closures by picture", std::to_string(by_picture_));
    add("closures by cloud", std::to_string(by_cloud_));
    add("places told to the localization", std::to_string(told_));
    add("way since a closure [m]", std::to_string(mapper_.way_since_closure()));
    const std::size_t seen = key_frames() - first_;
    add("per key frame [ms]",
        std::to_string(seen > 0 ? 1e3 * calculated_ / static_cast<double>(seen) : 0));
    diagnostic_msgs::DiagnosticArray message;
    message.header.stamp = ros::Time::now();
    message.status.push_back(status);
    diagnostics_.publish(message);
  }

  bool Save(std::string& message) {
    if (settings_.map_folder == kNone) return message = "~map_folder is not set", false;
    if (key_frames() == 0) return message = "there is no map yet", false;
    MapStore& store = *mapper_.store();
    const auto version =
        SaveSlamMap(settings_.map_folder, mapper_.Map(),
                    [&store](std::uint32_t key_frame) { return store.ReadPacked(key_frame); });
    if (!version) {
      message = version.problem();
      ROS_ERROR("%s", message.c_str());
      return false;
    }
    saved_ = key_frames();
    problem_ = store.SetVersion(*version).problem();
    message = "saved as version " + std::to_string(*version) + " in " + settings_.map_folder;
    ROS_INFO("%s", message.c_str());
    return true;
  }

  const Settings settings_;
  ros::NodeHandle node_;
  Transforms transforms_;
  SlamMapper mapper_;
  std::size_t first_ = 0;  // that this program adds
  std::size_t first_of_session_ = 0;
  std::size_t saved_ = 0;
  localization::PoseHistory history_{4};
  LocalizationLink localization_{node_, history_, [this] { BeginAnew(", carried"); }};
  Pose2D newest_odometry_;                    // of the newest key frame
  std::vector<std::optional<Pose3>> frames_;  // of each session's map, in that of the navigation
  std::optional<Pose3> frame_on_map_;   // of the newest key frame's map, in that of the navigation
  std::optional<double> waits_since_;   // for a picture
  double asked_stamp_ = -kAskPeriod;    // when pictures were looked at last
  Pose3 asked_at_ = Pose3::Identity();  // odometry
  std::size_t told_ = 0;
  std::optional<double> began_;  // stamp of the first cloud of this session
  int frame_ = -1;               // of the odometry
  std::vector<std::unique_ptr<perception::RgbdTopics>> cameras_;
  sensor_msgs::PointCloud2::ConstPtr cloud_;  // not yet used
  std::vector<perception::LidarPoint> points_;
  ros::WallTime last_cloud_ = ros::WallTime::now();
  std::string problem_;  // of the last cloud
  std::string asked_;    // of the surroundings
  std::size_t by_picture_ = 0, by_cloud_ = 0;
  double calculated_ = 0;  // s, for all key frames
  ros::Publisher pose_, grid_, markers_, diagnostics_;
  ros::Subscriber odometry_subscriber_, clouds_subscriber_;
  ros::ServiceServer save_;
  ros::Timer grid_timer_;
  ros::WallTimer draw_timer_, state_timer_;
  VoxelDrawing voxels_{settings_.mapper.resolution, settings_.mapper.lidar};  // before all of them
};

int Fail(const std::string& problem) {
  ROS_ERROR("%s", problem.c_str());
  return 2;
}

std::string FileOr(const std::string& file, const char* shipped) {
  return file == kShipped ? Shipped(shipped) : file;
}

int Run(Settings settings) {
  const auto surroundings = AskedSurroundings(settings.surroundings);
  if (!surroundings) return Fail(surroundings.problem());
  if (settings.mapping != "yes" && settings.mapping != "no") {
    return Fail("mapping: expected yes or no, not \"" + settings.mapping + "\"");
  }
  // Nothing is added and moved, so that all may be asked for.
  settings.mapper.working = settings.maps() ? static_cast<std::size_t>(settings.working)
                                            : std::numeric_limits<std::size_t>::max();
  const auto vocabulary = Vocabulary::Load(FileOr(settings.vocabulary, COPPICE_VOCABULARY));
  if (!vocabulary) return Fail(vocabulary.problem());
  const auto classifier = PlaceClassifier::Load(FileOr(settings.classifier, COPPICE_PLACES));
  if (!classifier) return Fail(classifier.problem());
  auto opened = OpenMapFolder(settings.map_folder == kNone ? "" : settings.map_folder);
  if (!opened) return Fail(opened.problem());
  if (!opened->remark.empty()) ROS_WARN("%s", opened->remark.c_str());
  MapStore& store = *opened->store;
  SlamNode node(settings, *vocabulary, *classifier, std::move(opened->store));
  Outcome started = node.Start(std::move(opened->map));
  if (started) started = store.SetVersion(opened->version);
  if (!started) return Fail(started.problem());
  ros::spin();
  node.KeepWhatIsUnsaved();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::slam

int main(int argc, char** argv) {
  using namespace coppice::robot::slam;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(argc, argv, "slam", kHelp, Run);
}
