#include "robot_app/simulation/floor_scene.h"

namespace coppice::robot::simulation {
namespace {

void AddWalls(const std::vector<std::vector<Vec2>>& walls, double height, StillScene& still) {
  for (const auto& wall : walls) {
    for (std::size_t i = 1; i < wall.size(); ++i) {
      still.panels.push_back({{wall[i - 1], wall[i]}, height, Material::kWall});
    }
  }
}

}  // namespace

StillScene MakeStillScene(const Floor& floor, const std::vector<bool>& door_open,
                          const std::vector<bool>& place_blocked,
                          const std::optional<Triangle>& landmark) {
  StillScene still;
  if (!floor.sky) still.ceiling = floor.wall_height;
  still.light = floor.light;
  AddWalls(floor.walls, floor.wall_height, still);
  for (const FloorBox& box : floor.furniture) {
    still.AddBox(box.shape, box.height, box.is_poster ? Material::kPoster : Material::kFurniture);
  }
  for (std::size_t i = 0; i < floor.places.size(); ++i) {
    const FloorBox& box = floor.places[i];
    if (place_blocked[i]) still.AddBox(box.shape, box.height, Material::kCardboard);
  }
  for (std::size_t i = 0; i < floor.doors.size(); ++i) {
    const auto leaf = DoorLeaf(floor.doors[i], door_open[i]);
    if (leaf) still.panels.push_back({*leaf, floor.wall_height, Material::kDoor});
  }
  if (landmark) {
    for (const Segment& side : SidesOf(*landmark)) {
      still.panels.push_back({side, floor.landmark->height, Material::kFurniture});
    }
  }
  return still;
}

StillScene MakeStillScene(const Floor& floor) {
  std::vector<bool> door_open;
  for (const Door& door : floor.doors) door_open.push_back(door.open);
  return MakeStillScene(floor, door_open, std::vector<bool>(floor.places.size(), false),
                        LandmarkOf(floor));
}

std::optional<Triangle> LandmarkOf(const Floor& floor, const Pose2& moved) {
  if (!floor.landmark) return std::nullopt;
  return LandmarkAt(floor.landmark->shape, Compose(floor.docked, moved));
}

StillScene WithGlass(StillScene still, const Floor& floor) {
  AddWalls(floor.glass, floor.wall_height, still);
  return still;
}

}  // namespace coppice::robot::simulation
