#include "robot_app/training/random_hall.h"

#include <algorithm>

#include "robot_app/simulation/world.h"
#include "robot_app/training/draw.h"

namespace coppice::robot::training {
namespace {

using simulation::kPi;
using simulation::Material;
using simulation::Rectangle;
using simulation::StillScene;
using simulation::Vec2;

struct Kind {
  double least_width, most_width, least_depth, most_depth, least_height, most_height;
  Material material;
  int most;  // of it in a hall
};

constexpr Kind kKinds[] = {
    {1.2, 1.8, 0.7, 0.9, 0.7, 0.78, Material::kFurniture, 6},    // desks
    {0.8, 1.8, 0.35, 0.6, 1.6, 2.1, Material::kFurniture, 5},    // cupboards
    {0.4, 0.55, 0.4, 0.55, 0.8, 1.2, Material::kFurniture, 12},  // chairs
    {0.25, 0.6, 0.25, 0.6, 2.6, 3.5, Material::kWall, 5},        // columns
    {0.25, 0.7, 0.25, 0.7, 0.9, 1.7, Material::kFurniture, 6},   // plants, bins
    {0.1, 0.3, 0.1, 0.3, 1.4, 1.9, Material::kFurniture, 5},     // coat racks, signs
    {0.35, 0.7, 0.2, 0.5, 1.3, 2.0, Material::kCardboard, 6},    // boxes, machines
    {1.5, 3.0, 0.4, 0.6, 0.4, 0.5, Material::kFurniture, 3},     // benches
};

void AddWall(StillScene& still, Vec2 a, Vec2 b, double height) {
  still.panels.push_back({{a, b}, height, Material::kWall});
}

void AddOuterWalls(StillScene& still, Vec2 half, double height) {
  const Vec2 corners[] = {
      {-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
  for (int i = 0; i < 4; ++i) AddWall(still, corners[i], corners[(i + 1) % 4], height);
}

// Walls across the hall with a gap to walk through.
void AddPartitions(StillScene& still, Vec2 half, double height, std::mt19937_64& random) {
  const int count = static_cast<int>(random() % 3);
  for (int i = 0; i < count; ++i) {
    const double x = Draw(random, -half.x + 2, half.x - 2);
    const double gap = Draw(random, -half.y + 1, half.y - 1);
    AddWall(still, {x, -half.y}, {x, gap - 0.6}, height);
    AddWall(still, {x, gap + 0.6}, {x, half.y}, height);
  }
}

}  // namespace

Site SiteOf(const simulation::Floor& floor) {
  Vec2 low{1e9, 1e9}, high{-1e9, -1e9};
  for (const auto& wall : floor.walls) {
    for (const Vec2 point : wall) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
  }
  return {simulation::World(floor).still(), {(low + high) * 0.5, high - low, 0}};
}

bool IsFree(const Site& site, Vec2 point, double radius) {
  const Vec2 local = simulation::Rotated(point - site.area.center, -site.area.yaw);
  if (std::abs(local.x) > site.area.size.x / 2 || std::abs(local.y) > site.area.size.y / 2) {
    return false;
  }
  const auto touches_panel = [&](const simulation::Panel& panel) {
    return simulation::Distance(point, panel.edge) < radius;
  };
  const auto touches_roof = [&](const simulation::Roof& roof) {
    return simulation::Distance(point, roof.shape) < radius;
  };
  return std::none_of(site.still.panels.begin(), site.still.panels.end(), touches_panel) &&
         std::none_of(site.still.roofs.begin(), site.still.roofs.end(), touches_roof);
}

Site MakeRandomHall(std::mt19937_64& random) {
  Site site;
  const Vec2 half{Draw(random, 4, 12), Draw(random, 2, 10)};
  const double height = Draw(random, 2.4, 4);
  site.area = {{0, 0}, half * 2, 0};
  site.still.ceiling = height;
  AddOuterWalls(site.still, half, height);
  AddPartitions(site.still, half, height, random);
  for (const Kind& kind : kKinds) {
    const int count = static_cast<int>(random() % (kind.most + 1));
    for (int i = 0; i < count; ++i) {
      const Vec2 size{Draw(random, kind.least_width, kind.most_width),
                      Draw(random, kind.least_depth, kind.most_depth)};
      const Vec2 center{Draw(random, -half.x, half.x), Draw(random, -half.y, half.y)};
      const double yaw = random() % 2 == 0 ? 0 : Draw(random, 0, kPi);
      const double top = std::min(Draw(random, kind.least_height, kind.most_height), height);
      // Some stand at a wall, some in a row with others.
      if (!IsFree(site, center, random() % 3 == 0 ? 0 : simulation::Length(size) / 2)) continue;
      site.still.AddBox({center, size, yaw}, top, kind.material);
    }
  }
  return site;
}

}  // namespace coppice::robot::training
