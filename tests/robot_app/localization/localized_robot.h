// The simulated robot with odometry filter and localization, without ROS and without delay.
#ifndef COPPICE_TESTS_ROBOT_APP_LOCALIZATION_LOCALIZED_ROBOT_H_
#define COPPICE_TESTS_ROBOT_APP_LOCALIZATION_LOCALIZED_ROBOT_H_

#include <random>
#include <utility>
#include <vector>

#include "robot_app/localization/localizer.h"
#include "robot_app/localization/odometry_filter.h"
#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot::localization {

class LocalizedRobot {
 public:
  LocalizedRobot(const simulation::Floor& floor, const Pose2D& start, std::uint64_t seed,
                 LocalizerSettings settings = {})
      : LocalizedRobot(floor, Options(start, seed), settings) {}
  LocalizedRobot(const simulation::Floor& floor, const simulation::WorldOptions& options,
                 LocalizerSettings settings = {})
      : world_(floor, options), localizer_(WithSeed(settings, options.seed)) {
    localizer_.SetMap(navigation::MapOf(floor));
  }

  /// Somebody carries the robot away: its wheels and its gyroscope notice nothing. Waits until
  /// nobody stands there.
  void Carry(const Pose2D& pose) {
    while (!world_.Kidnap({pose.x, pose.y, pose.yaw})) Step({});
  }

  /// What is taken for the scan; else ScanOf(world).
  void SetLook(navigation::Look look) { look_ = std::move(look); }

  void RestartOdometry() { filter_ = OdometryFilter(); }

  void Step(const Velocity2D& command) {
    world_.Step(0.02, simulation::Velocity{command.linear, command.angular});
    const simulation::Odometry& wheels = world_.odometry();
    filter_.AddYawRate(now(), world_.imu().yaw_rate, 0);
    if (wheels.time() != wheels_time_) {
      wheels_time_ = wheels.time();
      filter_.AddWheels(now(), {wheels.pose().x, wheels.pose().y, wheels.pose().yaw},
                        {wheels.velocity().linear, wheels.velocity().angular});
    }
    if (filter_.started()) localizer_.AddOdometry(filter_.stamp(), filter_.pose());
    if (world_.scan().time == scan_time_) return;
    scan_time_ = world_.scan().time;
    localizer_.AddScan(look_(world_));
  }

  /// Constant speed for a while. Returns the seconds until `done` first came true, or -1.
  template <typename Done>
  double DriveUntil(const Velocity2D& velocity, double seconds, Done done) {
    const double start = now();
    while (now() < start + seconds) {
      Step(velocity);
      if (done()) return now() - start;
    }
    return -1;
  }
  void Drive(const Velocity2D& velocity, double seconds) {
    DriveUntil(velocity, seconds, [] { return false; });
  }
  void TurnOnce() { Drive({0, 0.4}, 2 * M_PI / 0.4); }

  double now() const { return world_.time(); }
  simulation::World& world() { return world_; }
  Localizer& localizer() { return localizer_; }
  const OdometryFilter& filter() const { return filter_; }
  LocalizationReport Report() const { return localizer_.Report(now()); }
  bool IsOk() const { return Report().phase == LocalizationPhase::kOk; }
  bool IsLost() const { return Report().phase == LocalizationPhase::kLost; }
  Pose2D Truth() const { return navigation::PoseOf(world_); }
  /// base_link in the map now, as tf would tell it.
  Pose2D Estimate() const { return Compose(localizer_.odom_in_map(), filter_.pose()); }
  double Error() const { return Distance(Estimate(), Truth()); }
  double YawError() const { return std::abs(NormalizeAngle(Estimate().yaw - Truth().yaw)); }

 private:
  static simulation::WorldOptions Options(const Pose2D& start, std::uint64_t seed) {
    simulation::WorldOptions options;
    options.start = simulation::Pose2{start.x, start.y, start.yaw};
    options.seed = seed;
    return options;
  }
  static LocalizerSettings WithSeed(LocalizerSettings settings, std::uint64_t seed) {
    settings.seed = seed;
    return settings;
  }

  simulation::World world_;
  navigation::Look look_ = navigation::SeesAll;
  double scan_time_ = -1;
  double wheels_time_ = -1;
  OdometryFilter filter_;
  Localizer localizer_;
};

/// Places where the robot can stand with room around it, drawn evenly from the floor.
inline std::vector<Pose2D> RandomPoses(const OccupancyGrid& map, int count, unsigned seed) {
  std::vector<std::uint8_t> blocked(map.cells.size());
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    blocked[i] = map.Blocked(static_cast<int>(i)) ? 1 : 0;
  }
  const std::vector<float> room = DistanceTransform(map.frame, blocked, 1);
  std::mt19937 random(seed);
  std::vector<Pose2D> poses;
  while (static_cast<int>(poses.size()) < count) {
    const int i = static_cast<int>(random() % map.frame.size());
    const double yaw = static_cast<double>(random() % 6283) / 1000 - M_PI;
    if (room[i] < 0.45) continue;
    const Point2D center = map.frame.Center(map.frame.CellOf(i));
    poses.push_back({center.x, center.y, yaw});
  }
  return poses;
}

}  // namespace coppice::robot::localization

#endif  // COPPICE_TESTS_ROBOT_APP_LOCALIZATION_LOCALIZED_ROBOT_H_
