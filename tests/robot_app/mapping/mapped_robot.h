// The simulated robot with odometry filter and mapper, driven by a person who knows the way;
// without ROS and without delay.
#ifndef COPPICE_TESTS_ROBOT_APP_MAPPING_MAPPED_ROBOT_H_
#define COPPICE_TESTS_ROBOT_APP_MAPPING_MAPPED_ROBOT_H_

#include <algorithm>
#include <utility>
#include <vector>

#include "robot_app/localization/odometry_filter.h"
#include "robot_app/mapping/mapper.h"
#include "tests/robot_app/mapping/tour.h"
#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot::mapping {

/// What the odometry gets wrong, beyond what the simulated wheels and gyroscope do.
struct BadOdometry {
  double longer = 0;   ///< share by which each way seems longer
  double twisted = 0;  ///< turn that it sees on each metre [rad]
};

class MappedRobot {
 public:
  MappedRobot(const simulation::Floor& floor, const Pose2D& start, std::uint64_t seed,
              BadOdometry bad = {}, MappingSettings settings = {})
      : world_(floor, Options(start, seed)), bad_(bad), mapper_(settings, start) {}

  /// Drives along the points. False if it does not get there.
  bool Drive(const std::vector<Point2D>& way) {
    Tour tour(way);
    const double deadline = now() + 60 + 10 * tour.Length();
    while (const auto command = tour.Next(Truth())) {
      if (now() > deadline) return false;
      Step(*command);
    }
    return true;
  }

  void Step(const Velocity2D& command) {
    world_.Step(0.02, simulation::Velocity{command.linear, command.angular});
    const simulation::Odometry& wheels = world_.odometry();
    filter_.AddYawRate(now(), world_.imu().yaw_rate, 0);
    if (wheels.time() != wheels_time_) {
      wheels_time_ = wheels.time();
      filter_.AddWheels(now(), {wheels.pose().x, wheels.pose().y, wheels.pose().yaw},
                        {wheels.velocity().linear, wheels.velocity().angular});
    }
    if (filter_.started()) AddOdometry();
    if (world_.scan().time == scan_time_) return;
    scan_time_ = world_.scan().time;
    mapper_.AddScan(look_(world_));
    if (mapper_.started()) farthest_off_ = std::max(farthest_off_, Error());
  }

  /// What is taken for the scan; else ScanOf(world).
  void SetLook(navigation::Look look) { look_ = std::move(look); }

  void Carry(const Pose2D& pose) {
    while (!world_.Kidnap({pose.x, pose.y, pose.yaw})) Step({});
  }

  void RestartOdometry() {
    filter_ = localization::OdometryFilter();
    believed_ = {100, 50, 1};  // another frame
    was_filtered_ = false;
  }

  double now() const { return world_.time(); }
  Mapper& mapper() { return mapper_; }
  Pose2D Truth() const { return navigation::PoseOf(world_); }
  /// What the odometry says.
  Pose2D believed() const { return believed_; }
  /// Of the newest pose, and the greatest so far [m].
  double Error() const { return Distance(Compose(mapper_.odom_in_map(), believed_), Truth()); }
  double farthest_off() const { return farthest_off_; }

 private:
  static simulation::WorldOptions Options(const Pose2D& start, std::uint64_t seed) {
    simulation::WorldOptions options;
    options.start = simulation::Pose2{start.x, start.y, start.yaw};
    options.seed = seed;
    return options;
  }

  void AddOdometry() {
    Pose2D moved = RelativeTo(filtered_, filter_.pose());
    if (was_filtered_) {
      const double way = std::hypot(moved.x, moved.y);
      moved.x *= 1 + bad_.longer;
      moved.y *= 1 + bad_.longer;
      moved.yaw += bad_.twisted * way;
      believed_ = Compose(believed_, moved);
    }
    filtered_ = filter_.pose();
    was_filtered_ = true;
    mapper_.AddOdometry(filter_.stamp(), believed_);
  }

  simulation::World world_;
  navigation::Look look_ = navigation::SeesAll;
  BadOdometry bad_;
  localization::OdometryFilter filter_;
  Mapper mapper_;
  Pose2D filtered_;
  Pose2D believed_;
  bool was_filtered_ = false;
  double scan_time_ = -1;
  double wheels_time_ = -1;
  double farthest_off_ = 0;
};

}  // namespace coppice::robot::mapping

#endif  // COPPICE_TESTS_ROBOT_APP_MAPPING_MAPPED_ROBOT_H_
