// Turns of a lidar in a room that looks alike from nowhere, and in a corridor that does.
#ifndef COPPICE_TESTS_ROBOT_APP_SLAM_CLOUDS_ROOM_H_
#define COPPICE_TESTS_ROBOT_APP_SLAM_CLOUDS_ROOM_H_

#include <cmath>
#include <vector>

#include "robot_app/simulation/lidar_3d.h"
#include "robot_app/slam/clouds/cloud_descriptor.h"

namespace coppice::robot::slam {

inline CloudPoints TurnIn(const simulation::StillScene& still, const simulation::Pose2& robot,
                          std::uint64_t seed) {
  const simulation::Scene scene(still);
  simulation::Lidar3d lidar({}, seed);
  lidar.Turn(0, 1.0001 * lidar.options().period, robot, scene);
  CloudPoints points;
  for (const simulation::CloudPoint& point : lidar.cloud().points) {
    if (std::isfinite(point.x)) points.emplace_back(point.x, point.y, point.z + 1.2F);
  }
  return points;
}

inline simulation::StillScene Walls(const std::vector<simulation::Vec2>& corners) {
  simulation::StillScene still;
  still.ceiling = 2.5;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    still.panels.push_back({{corners[i - 1], corners[i]}, 2.5, simulation::Material::kWall});
  }
  return still;
}

// 7 m by 4 m with an alcove, a cupboard and a table.
inline CloudPoints RoomFrom(double x, double y, double yaw, std::uint64_t seed = 1) {
  simulation::StillScene still =
      Walls({{-4, -2}, {3, -2}, {3, 0.5}, {4.2, 0.5}, {4.2, 2}, {-4, 2}, {-4, -2}});
  still.AddBox({{-1.5, 1.7}, {1.6, 0.5}, 0}, 1.9, simulation::Material::kFurniture);
  still.AddBox({{1.8, -1.3}, {1.2, 0.8}, 0.3}, 0.75, simulation::Material::kFurniture);
  return TurnIn(still, {x, y, yaw}, seed);
}

inline CloudPoints CorridorFrom(double x, double y, double yaw, std::uint64_t seed = 1) {
  return TurnIn(Walls({{-60, 1.2}, {60, 1.2}, {60, -1.2}, {-60, -1.2}, {-60, 1.2}}), {x, y, yaw},
                seed);
}

}  // namespace coppice::robot::slam

#endif  // COPPICE_TESTS_ROBOT_APP_SLAM_CLOUDS_ROOM_H_
