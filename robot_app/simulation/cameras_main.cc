// coppice-simulated-cameras: both RGB-D cameras of the simulated robot, as the ROS node
// /simulated_cameras. A program of its own, so that drawing does not hold the simulation up. Its
// topics and parameters: --help.
#include <coppice_msgs/SimulatedWorld.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "robot_app/common/compressed_picture.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/simulation/camera/rgbd_camera.h"
#include "robot_app/simulation/floor_scene.h"
#include "robot_app/simulation/late_messages.h"
#include "robot_app/simulation/shipped_files.h"

namespace coppice::robot::simulation {
namespace {

constexpr char kHelp[] =
    "coppice-simulated-cameras: both RGB-D cameras of the simulated robot, as the ROS node\n"
    "/simulated_cameras. NAME is front or rear. Pictures are drawn only for who subscribes.\n"
    "  subscribes  /simulation/world (of coppice-simulator)\n"
    "  publishes   /camera/NAME/color/image_raw/compressed (JPEG)\n"
    "              /camera/NAME/color/camera_info\n"
    "              /camera/NAME/aligned_depth_to_color/image_raw/compressedDepth (PNG, mm)\n";

using SteadyClock = std::chrono::steady_clock;
// A real camera takes ten in a second. A simulation that runs faster shall not take more of the
// computer.
constexpr std::chrono::milliseconds kRest(80);

struct Settings {
  std::string floor_file = kInstitute;
  std::string robot_file = kSobi;
  std::uint64_t seed = 1;
  double light = 0;
  Floor floor;
};

Parameters ParametersOf(Settings& settings) {
  return {{"floor", &settings.floor_file, "description of the floor, as the simulator's"},
          {"robot", &settings.robot_file, "description of the robot, as the simulator's"},
          {"seed", &settings.seed, 0, 1e9, "of the noise and of how people look"},
          {"light", &settings.light, 0, 1, "1: sun or lamps, 0.1: dusk; 0: as the floor"}};
}

sensor_msgs::CameraInfo InfoOf(const RgbdOptions& options) {
  sensor_msgs::CameraInfo info;
  info.width = static_cast<std::uint32_t>(options.width);
  info.height = static_cast<std::uint32_t>(options.height);
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0);
  const Lens& lens = options.lens;
  info.K = {lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {lens.fx, 0, lens.cx, 0, 0, lens.fy, lens.cy, 0, 0, 0, 1, 0};
  return info;
}

// How the people of a floor look is drawn by lot, the same at every start.
std::vector<PersonLook> LooksOf(const Floor& floor, std::uint64_t seed) {
  std::vector<PersonLook> looks;
  for (std::size_t i = 0; i < floor.people.size(); ++i) {
    looks.push_back(RandomPersonLook(1000 * seed + i));
    looks.back().wears_mask = floor.people[i].mask;
  }
  return looks;
}

// One camera and its topics.
class Station {
 public:
  Station(ros::NodeHandle& node, const std::string& name, const Mount& mount, std::uint64_t seed,
          const ros::SubscriberStatusCallback& changed)
      : name_(name), mount_(mount), camera_({}, seed) {
    const std::string camera = "/camera/" + name;
    colour_ = node.advertise<sensor_msgs::CompressedImage>(camera + "/color/image_raw/compressed",
                                                           2, changed, changed);
    depth_ = node.advertise<sensor_msgs::CompressedImage>(
        camera + "/aligned_depth_to_color/image_raw/compressedDepth", 2, changed, changed);
    info_ =
        node.advertise<sensor_msgs::CameraInfo>(camera + "/color/camera_info", 2, changed, changed);
  }

  bool IsWatched() const { return IsSeen() || info_.getNumSubscribers() > 0; }

  void Publish(const Scene& scene, const std::vector<SeenPerson>& people,
               const coppice_msgs::SimulatedWorld& world) {
    late_.Send(world.header.stamp.toSec());
    coppice_msgs::SimulatedCamera state;
    state.copies = 1;
    for (const auto& camera : world.cameras) {
      if (camera.name == name_) state = camera;
    }
    if (!IsWatched() || state.copies == 0) return;
    const auto add = [&](const ros::Publisher& publisher, const auto& message) {
      const double time = world.header.stamp.toSec() + state.lag;
      for (int copy = 0; copy < state.copies; ++copy) late_.Add(time, publisher, message);
    };
    if (IsSeen()) {
      const Pose2 base{world.robot.x, world.robot.y, world.robot.theta};
      const Pose2 lens = Compose(base, {mount_.pose.x, mount_.pose.y, mount_.pose.yaw});
      const RgbdPicture seen =
          camera_.Take(scene, people, lens, mount_.height, {state.is_covered != 0, state.broken});
      if (colour_.getNumSubscribers() > 0) {
        add(colour_, MessageOf(world, kJpegFormat, EncodeJpeg(seen.colour)));
      }
      if (depth_.getNumSubscribers() > 0) {
        add(depth_, MessageOf(world, kDepthFormat, EncodeDepth(seen.depth)));
      }
    }
    sensor_msgs::CameraInfo info = InfoOf(camera_.options());
    info.header = HeaderOf(world);
    add(info_, info);
    late_.Send(world.header.stamp.toSec());
  }

 private:
  bool IsSeen() const { return colour_.getNumSubscribers() > 0 || depth_.getNumSubscribers() > 0; }
  std_msgs::Header HeaderOf(const coppice_msgs::SimulatedWorld& world) const {
    std_msgs::Header header;
    header.stamp = world.header.stamp;
    header.frame_id = "camera_" + name_ + "_optical";
    return header;
  }
  sensor_msgs::CompressedImage MessageOf(const coppice_msgs::SimulatedWorld& world,
                                         const char* format,
                                         std::vector<std::uint8_t> bytes) const {
    sensor_msgs::CompressedImage message;
    message.header = HeaderOf(world);
    message.format = format;
    message.data = std::move(bytes);
    return message;
  }

  std::string name_;
  Mount mount_;
  RgbdCamera camera_;
  ros::Publisher colour_, depth_, info_;
  LateMessages late_;
};

class CamerasNode {
 public:
  CamerasNode(const Settings& settings, const std::vector<Mount>& mounts)
      : settings_(settings), looks_(LooksOf(settings.floor, settings.seed)) {
    const ros::SubscriberStatusCallback changed = [this](const ros::SingleSubscriberPublisher&) {
      Watch();
    };
    for (std::size_t i = 0; i < kCameras.size(); ++i) {
      const std::uint64_t seed = kCameras.size() * settings.seed + i;
      stations_.emplace_back(node_, kCameras[i], mounts[i], seed, changed);
    }
  }

 private:
  // The simulator tells how its world is only as long as somebody wants pictures of it.
  void Watch() {
    bool is_watched = false;
    for (const Station& station : stations_) is_watched |= station.IsWatched();
    if (is_watched == static_cast<bool>(subscriber_)) return;
    subscriber_ = is_watched ? node_.subscribe("/simulation/world", 1, &CamerasNode::Draw, this)
                             : ros::Subscriber();
  }

  void Draw(const coppice_msgs::SimulatedWorld& world) {
    const auto now = SteadyClock::now();
    if (now < rests_until_ || !Follow(world)) return;
    rests_until_ = now + kRest;
    std::vector<SeenPerson> people;
    for (std::size_t i = 0; i < world.people.size(); ++i) {
      const coppice_msgs::SimulatedPerson& person = world.people[i];
      Stance stance;
      stance.position = {person.x, person.y};
      stance.heading = person.heading;
      stance.walked = person.walked;
      stance.walks = person.walks;
      stance.height = settings_.floor.people[i].height;
      people.push_back({stance, looks_[i]});
    }
    for (Station& station : stations_) station.Publish(scene_, people, world);
  }

  static bool IsSame(const std::optional<Triangle>& a, const std::optional<Triangle>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return std::equal(a->begin(), a->end(), b->begin(),
                      [](Vec2 p, Vec2 q) { return p.x == q.x && p.y == q.y; });
  }

  // Builds the scene anew if a door, a box or the station has moved. False if the world is that of
  // another floor.
  bool Follow(const coppice_msgs::SimulatedWorld& world) {
    const Floor& floor = settings_.floor;
    if (world.people.size() != floor.people.size() ||
        world.door_open.size() != floor.doors.size() ||
        world.place_blocked.size() != floor.places.size()) {
      ROS_ERROR_THROTTLE(5,
                         "/simulation/world is that of another floor than \"%s\"; expected the "
                         "simulator's parameter floor",
                         floor.name.c_str());
      return false;
    }
    const std::vector<bool> doors(world.door_open.begin(), world.door_open.end());
    const std::vector<bool> places(world.place_blocked.begin(), world.place_blocked.end());
    const auto& moved = world.station_moved;
    const auto landmark =
        world.landmark ? LandmarkOf(floor, {moved.x, moved.y, moved.theta}) : std::nullopt;
    if (!is_built_ || doors != doors_ || places != places_ || !IsSame(landmark, landmark_)) {
      scene_ = Scene(MakeStillScene(floor, doors, places, landmark));
      doors_ = doors;
      places_ = places;
      landmark_ = landmark;
      is_built_ = true;
    }
    return true;
  }

  const Settings& settings_;
  std::vector<PersonLook> looks_;
  ros::NodeHandle node_;
  std::vector<Station> stations_;
  ros::Subscriber subscriber_;
  bool is_built_ = false;
  std::vector<bool> doors_, places_;  // of the scene
  std::optional<Triangle> landmark_;  // the same
  Scene scene_;
  SteadyClock::time_point rests_until_{};
};

// Of all cameras, in their order.
Expected<std::vector<Mount>> MountsOf(const RobotDescription& robot) {
  std::vector<Mount> mounts;
  for (const char* const name : kCameras) {
    const Expected<Mount> mount = robot.MountOf(std::string("camera_") + name);
    if (!mount) return Problem{mount.problem()};
    mounts.push_back(*mount);
  }
  return mounts;
}

int Run(Settings& settings) {
  const auto refuse = [](const std::string& problem) {
    std::fprintf(stderr, "coppice-simulated-cameras: %s\n", problem.c_str());
    return 2;
  };
  const Expected<Floor> floor = FindFloor(settings.floor_file);
  if (!floor) return refuse(floor.problem());
  settings.floor = *floor;
  if (settings.light > 0) settings.floor.light = settings.light;
  const Expected<RobotDescription> robot = FindRobot(settings.robot_file);
  if (!robot) return refuse(robot.problem());
  const Expected<std::vector<Mount>> mounts = MountsOf(*robot);
  if (!mounts) return refuse(settings.robot_file + ": " + mounts.problem());
  const CamerasNode node(settings, *mounts);
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::simulation

int main(int argc, char** argv) {
  using namespace coppice::robot::simulation;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(argc, argv, "simulated_cameras", kHelp, Run);
}
