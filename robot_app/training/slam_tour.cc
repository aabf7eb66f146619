#include "robot_app/training/slam_tour.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "robot_app/localization/odometry_filter.h"
#include "robot_app/simulation/appearance/person_look.h"
#include "robot_app/simulation/floor_scene.h"
#include "robot_app/simulation/odometry.h"
#include "robot_app/training/draw.h"

namespace coppice::robot::training {
namespace {

using simulation::Pose2;
using simulation::Vec2;

constexpr double kStep = 0.05;    // s
constexpr double kSpeed = 0.5;    // m/s
constexpr double kTurning = 0.6;  // rad/s
constexpr double kAround = 6;     // m: people are within this distance of the robot

// A robot on wheels, with what it knows of its motion.
class Wheels {
 public:
  explicit Wheels(const Pose2& start, std::uint64_t seed)
      : truth_(start), odometry_({}, seed), imu_(seed + 1) {}

  void Move(double forward, double turn) {
    const simulation::Velocity velocity{forward / kStep, turn / kStep};
    truth_ = Compose(truth_, {forward, 0, turn});
    way_ += forward;
    time_ += kStep;
    odometry_.Move(forward, turn);
    odometry_.Read(time_);
    imu_.Measure(kStep, velocity_, velocity);
    velocity_ = velocity;
    const Pose2& pose = odometry_.pose();
    filter_.AddWheels(time_, {pose.x, pose.y, pose.yaw},
                      {odometry_.velocity().linear, odometry_.velocity().angular});
    filter_.AddYawRate(time_, imu_.reading().yaw_rate, 0);
  }

  Stop stop() const {
    const Pose2D pose = filter_.pose();
    return {truth_, {pose.x, pose.y, pose.yaw}, way_};
  }
  const Pose2& truth() const { return truth_; }

 private:
  Pose2 truth_;
  double way_ = 0;
  double time_ = 0;
  simulation::Velocity velocity_;
  simulation::Odometry odometry_;
  simulation::Imu imu_;
  localization::OdometryFilter filter_;
};

class Driver {
 public:
  Driver(const Pose2& start, const TourSettings& settings)
      : settings_(settings), wheels_(start, settings.seed) {
    wheels_.Move(0, 0);
    stops_.push_back(wheels_.stop());
  }

  void DriveTo(Vec2 goal) {
    const Vec2 from = wheels_.truth().position();
    const double heading = std::atan2(goal.y - from.y, goal.x - from.x);
    double turn = simulation::NormalAngle(heading - wheels_.truth().yaw);
    for (; std::abs(turn) > 1e-9; turn -= Limited(turn, kTurning)) Move(0, Limited(turn, kTurning));
    double left = simulation::Length(goal - from);
    for (; left > 1e-9; left -= Limited(left, kSpeed)) Move(Limited(left, kSpeed), 0);
  }

  const std::vector<Stop>& stops() const { return stops_; }

 private:
  static double Limited(double left, double speed) {
    return std::clamp(left, -speed * kStep, speed * kStep);
  }

  void Move(double forward, double turn) {
    wheels_.Move(forward, turn);
    turned_ += std::abs(turn);
    const Stop stop = wheels_.stop();
    if (stop.way - stops_.back().way < settings_.step && turned_ < settings_.turn) return;
    stops_.push_back(stop);
    turned_ = 0;
  }

  const TourSettings& settings_;
  Wheels wheels_;
  double turned_ = 0;
  std::vector<Stop> stops_;
};

// The doors that the round of the institute goes through stay open.
bool IsPassed(const std::string& door) { return door == "door_101" || door == "door_103"; }

simulation::StillScene SceneOf(const simulation::Floor& floor, const TourSettings& settings) {
  std::mt19937_64 random(settings.seed + 77);
  std::vector<bool> open;
  for (const simulation::Door& door : floor.doors) {
    const bool moved = Draw(random, 0, 1) < settings.moved_doors && !IsPassed(door.name);
    open.push_back(door.open != moved);
  }
  auto still = simulation::MakeStillScene(
      floor, open, std::vector<bool>(floor.places.size(), false), simulation::LandmarkOf(floor));
  still.light = settings.light;
  return still;
}

}  // namespace

std::vector<Stop> Drive(const std::vector<Vec2>& way, const TourSettings& settings) {
  std::mt19937_64 random(settings.seed + 5);
  const auto aside = [&](Vec2 point) {
    return point + Vec2{Draw(random, -settings.aside, settings.aside),
                        Draw(random, -settings.aside, settings.aside)};
  };
  const Vec2 begin = aside(way[0]);
  const Vec2 first = way[1] - way[0];
  Driver driver({begin.x, begin.y, std::atan2(first.y, first.x)}, settings);
  for (std::size_t i = 1; i < way.size(); ++i) driver.DriveTo(aside(way[i]));
  return driver.stops();
}

std::vector<Vec2> RoundOfTheInstitute() {
  return {{-0.8, 0},   {20, -0.2},  {38, 0},   {42, 0.4}, {46, 0},   {47.5, -1.5},
          {47.5, 4.0}, {42.5, 4.0}, {42, 0.4}, {34, 0.2}, {24, 0.2}, {24, 3.6},
          {22.8, 3.2}, {24, 2.6},   {24, 0},   {16, 0.1}, {8, 0},    {8.2, 3.8},
          {7.2, 3.6},  {8, 2.4},    {8, 0},    {2, 0},    {-0.8, 0}};
}

Expected<RobotSensors> SensorsOf(const RobotDescription& robot) {
  RobotSensors sensors;
  for (std::size_t i = 0; i < simulation::kCameras.size(); ++i) {
    const auto mount = robot.MountOf(std::string("camera_") + simulation::kCameras[i]);
    if (!mount) return Problem{mount.problem()};
    const Pose2D& at = mount->pose;
    sensors.lenses[i] = {at.x, at.y, at.yaw};
    sensors.lens_height = mount->height;
    sensors.cameras[i] =
        slam::LevelCamera(simulation::RgbdOptions().lens, at.x, at.y, at.yaw, mount->height);
  }
  const auto lidar = robot.MountOf("velodyne");
  if (!lidar) return Problem{lidar.problem()};
  sensors.lidar_height = lidar->height;
  return sensors;
}

TourEyes::TourEyes(const simulation::Floor& floor, const RobotSensors& sensors,
                   const TourSettings& settings)
    : sensors_(sensors),
      settings_(settings),
      scene_(SceneOf(floor, settings)),
      lidar_({}, settings.seed + 11) {
  for (std::size_t i = 0; i < 2; ++i) {
    cameras_.emplace_back(simulation::RgbdOptions(), 2 * settings.seed + i);
  }
}

// Whoever is around; elsewhere at each stop.
void TourEyes::PlacePeople(const Stop& stop) {
  if (placed_at_ == stop.way) return;
  placed_at_ = stop.way;
  const auto centimetres = static_cast<std::uint64_t>(std::llround(stop.way * 100));
  std::mt19937_64 random(settings_.seed * 7919 + centimetres);
  people_.clear();
  for (int i = 0; i < settings_.people; ++i) {
    simulation::SeenPerson person;
    const Vec2 place{Draw(random, -kAround, kAround), Draw(random, -kAround, kAround)};
    person.stance.heading = Draw(random, 0, 2 * simulation::kPi);
    person.stance.walks = random() % 2 == 0;
    person.stance.walked = Draw(random, 0, simulation::kStride);
    person.look = simulation::RandomPersonLook(random());
    if (simulation::Length(place) < 0.8) continue;
    person.stance.position = stop.truth.position() + place;
    people_.push_back(person);
  }
  std::vector<simulation::Stance> stances;
  for (const simulation::SeenPerson& person : people_) stances.push_back(person.stance);
  scene_.SetFigures(simulation::MakeFigures(stances));
}

simulation::RgbdPicture TourEyes::TakePicture(const Stop& stop, std::size_t camera) {
  PlacePeople(stop);
  return cameras_[camera].Take(scene_, people_, Compose(stop.truth, sensors_.lenses[camera]),
                               sensors_.lens_height);
}

std::vector<Eigen::Vector3f> TourEyes::TakeCloud(const Stop& stop) {
  PlacePeople(stop);
  lidar_.Restart();
  lidar_.Turn(0, 1.0001 * lidar_.options().period, stop.truth, scene_);
  std::vector<Eigen::Vector3f> points;
  for (const simulation::CloudPoint& point : lidar_.cloud().points) {
    if (!std::isfinite(point.x)) continue;
    points.emplace_back(point.x, point.y, point.z + static_cast<float>(sensors_.lidar_height));
  }
  return points;
}

}  // namespace coppice::robot::training
