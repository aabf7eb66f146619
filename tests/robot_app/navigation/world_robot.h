// The simulated world as navigation and docking see it, without ROS and without delay.
#ifndef COPPICE_TESTS_ROBOT_APP_NAVIGATION_WORLD_ROBOT_H_
#define COPPICE_TESTS_ROBOT_APP_NAVIGATION_WORLD_ROBOT_H_

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "robot_app/common/laser_scan.h"
#include "robot_app/common/occupancy_grid.h"
#include "robot_app/common/range_reading.h"
#include "robot_app/simulation/grid_map.h"
#include "robot_app/simulation/world.h"
#include "tests/support/folders.h"

namespace coppice::robot::navigation {

inline simulation::Floor InstituteFloor() {
  Diagnostics diagnostics;
  auto floor = simulation::LoadFloor(
      SourceFolder() + "/robot_app/config/sites/institute/world.yaml", diagnostics);
  if (!floor) throw std::runtime_error(diagnostics.ToString());
  return *floor;
}

inline OccupancyGrid MapOf(const simulation::Floor& floor) {
  const simulation::GridMap map = simulation::MakeGridMap(floor, floor.resolution);
  return {{map.resolution, map.origin.x, map.origin.y, map.width, map.height}, map.cells};
}

inline Pose2D PoseOf(const simulation::World& world) {
  const simulation::Pose2 pose = world.robot();
  return {pose.x, pose.y, pose.yaw};
}

inline LaserScan ScanOf(const simulation::World& world) {
  const simulation::Scan& scan = world.scan();
  const simulation::LidarOptions& options = world.lidar().options();
  LaserScan result;
  result.stamp = scan.time;
  result.mount = {options.mounting.x, options.mounting.y, options.mounting.yaw};
  result.angle_min = scan.angle_min;
  result.angle_increment = scan.angle_step;
  result.range_min = options.min_range;
  result.range_max = options.max_range;
  result.ranges = scan.ranges;
  return result;
}

/// How a test looks at the world.
using Look = std::function<LaserScan(const simulation::World&)>;
inline LaserScan SeesAll(const simulation::World& world) { return ScanOf(world); }

/// The same without the beams that end within 0.4 m of somebody's middle: no reading (REP-117).
/// What a robot would see that knew where everybody is.
inline LaserScan ScanWithoutPeople(const simulation::World& world) {
  LaserScan scan = ScanOf(world);
  const Pose2D scanner = Compose(PoseOf(world), scan.mount);
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (!scan.Hit(beam)) continue;
    const double angle = scanner.yaw + scan.angle_min + scan.angle_increment * double(beam);
    const double x = scanner.x + scan.ranges[beam] * std::cos(angle);
    const double y = scanner.y + scan.ranges[beam] * std::sin(angle);
    for (const simulation::Disc& person : world.people()) {
      const double away = std::hypot(person.center.x - x, person.center.y - y);
      if (away < 0.4) scan.ranges[beam] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return scan;
}

/// What the sonars heard last, in the order of simulation::kSonars.
inline std::array<RangeReading, 3> EchoesOf(const simulation::World& world) {
  std::array<RangeReading, 3> readings;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const simulation::SonarOptions& options = world.sonars()[i].options();
    readings[i].stamp = world.echoes().time;
    readings[i].mount = {options.mounting.x, options.mounting.y, options.mounting.yaw};
    readings[i].field_of_view = options.field_of_view;
    readings[i].min_range = options.min_range;
    readings[i].max_range = options.max_range;
    readings[i].range = world.echoes().ranges[i];
  }
  return readings;
}

}  // namespace coppice::robot::navigation

#endif  // COPPICE_TESTS_ROBOT_APP_NAVIGATION_WORLD_ROBOT_H_
