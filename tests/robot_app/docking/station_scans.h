// Scans of the simulated laser from anywhere, without a robot that must drive there.
#ifndef COPPICE_TESTS_ROBOT_APP_DOCKING_STATION_SCANS_H_
#define COPPICE_TESTS_ROBOT_APP_DOCKING_STATION_SCANS_H_

#include <utility>
#include <vector>

#include "robot_app/docking/landmark.h"
#include "robot_app/simulation/floor_scene.h"
#include "robot_app/simulation/lidar.h"
#include "robot_app/simulation/people.h"
#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot::docking {

/// A room with its laser.
class StationScans {
 public:
  /// `more`: what else stands there.
  explicit StationScans(const simulation::Floor& floor, std::uint64_t seed = 1,
                        const std::vector<simulation::Segment>& more = {})
      : caster_(Edges(floor, more)), lidar_({}, seed) {}

  /// From base_link at `base` (map frame), with round things in the way.
  LaserScan From(const Pose2D& base, const std::vector<simulation::Disc>& discs = {}) {
    lidar_.Measure(0, {base.x, base.y, base.yaw}, caster_, discs);
    const simulation::LidarOptions& options = lidar_.options();
    LaserScan scan;
    scan.mount = {options.mounting.x, options.mounting.y, options.mounting.yaw};
    scan.angle_min = lidar_.scan().angle_min;
    scan.angle_increment = lidar_.scan().angle_step;
    scan.range_min = options.min_range;
    scan.range_max = options.max_range;
    scan.ranges = lidar_.scan().ranges;
    return scan;
  }

 private:
  static std::vector<simulation::Segment> Edges(const simulation::Floor& floor,
                                                std::vector<simulation::Segment> edges) {
    for (const simulation::Panel& panel : simulation::MakeStillScene(floor).panels) {
      if (panel.top > simulation::LidarOptions().height) edges.push_back(panel.edge);
    }
    return edges;
  }

  simulation::RayCaster caster_;
  simulation::Lidar lidar_;
};

/// The station at the wall of a bare hall, so that it can be looked at from the side.
inline simulation::Floor Hall() {
  simulation::Floor floor = navigation::InstituteFloor();
  floor.walls = {{{-3, -8}, {-3, 8}, {8, 8}, {8, -8}, {-3, -8}}};
  floor.furniture.clear();
  floor.doors.clear();
  floor.places.clear();
  return floor;
}

/// The pose of the floor's landmark in the map.
inline Pose2D LandmarkIn(const simulation::Floor& floor) {
  return LandmarkOf(floor.landmark->shape, {floor.docked.x, floor.docked.y, floor.docked.yaw});
}

/// base_link when its scanner is so far from the landmark [m], that far from its axis [rad], and
/// turned by `yaw` against the direction to it.
inline Pose2D SeenFrom(const Pose2D& landmark, double distance, double angle, double yaw = 0) {
  const Pose2D scanner =
      Compose(landmark, Pose2D{-distance * std::cos(angle), distance * std::sin(angle),
                               NormalizeAngle(-angle + yaw)});
  return Compose(scanner, RelativeTo(LaserScan().mount, Pose2D{}));
}

}  // namespace coppice::robot::docking

#endif  // COPPICE_TESTS_ROBOT_APP_DOCKING_STATION_SCANS_H_
