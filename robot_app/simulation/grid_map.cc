#include "robot_app/simulation/grid_map.h"

#include "robot_app/simulation/floor_scene.h"

namespace coppice::robot::simulation {
namespace {

constexpr double kBorder = 0.5;  // unknown cells around the floor, m
constexpr double kSeen = 0.25;   // lower things, such as kerbs, no laser sees, m

class Painter {
 public:
  Painter(const Floor& floor, double resolution) {
    map_.resolution = resolution;
    Vec2 low = floor.docked.position();
    Vec2 high = low;
    for (const auto& wall : floor.walls) {
      for (const Vec2& p : wall) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    // Half a cell more, so that walls on round coordinates lie in the middle of cells: the map is
    // not shifted against the floor.
    const double border = kBorder + resolution / 2;
    map_.origin = low - Vec2{border, border};
    const Vec2 size = high + Vec2{kBorder, kBorder} - map_.origin;
    map_.width = static_cast<int>(std::ceil(size.x / resolution));
    map_.height = static_cast<int>(std::ceil(size.y / resolution));
    map_.cells.assign(static_cast<std::size_t>(map_.width) * map_.height, GridMap::kUnknown);
  }

  void PaintLine(const Segment& s, std::int8_t value = GridMap::kOccupied) {
    const double length = Length(s.b - s.a);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / (map_.resolution / 4))));
    for (int i = 0; i <= steps; ++i) {
      PaintPoint(s.a + (s.b - s.a) * (static_cast<double>(i) / steps), value);
    }
  }

  void PaintOutline(const Rectangle& r, std::int8_t value = GridMap::kOccupied) {
    const auto corners = Corners(r);
    for (std::size_t i = 0; i < 4; ++i) PaintLine({corners[i], corners[(i + 1) % 4]}, value);
  }

  // Everything that is reached from `start` without crossing an occupied cell becomes free.
  void FillFree(Vec2 start) {
    std::vector<int> todo{Index(start)};
    while (!todo.empty()) {
      const int i = todo.back();
      todo.pop_back();
      if (i < 0 || map_.cells[i] != GridMap::kUnknown) continue;
      map_.cells[i] = GridMap::kFree;
      const int column = i % map_.width;
      const int row = i / map_.width;
      if (column > 0) todo.push_back(i - 1);
      if (column + 1 < map_.width) todo.push_back(i + 1);
      if (row > 0) todo.push_back(i - map_.width);
      if (row + 1 < map_.height) todo.push_back(i + map_.width);
    }
  }

  GridMap& map() { return map_; }

 private:
  int Index(Vec2 p) const {
    const int column = static_cast<int>(std::floor((p.x - map_.origin.x) / map_.resolution));
    const int row = static_cast<int>(std::floor((p.y - map_.origin.y) / map_.resolution));
    if (column < 0 || column >= map_.width || row < 0 || row >= map_.height) return -1;
    return row * map_.width + column;
  }

  void PaintPoint(Vec2 p, std::int8_t value) {
    const int i = Index(p);
    if (i >= 0) map_.cells[i] = value;
  }

  GridMap map_;
};

}  // namespace

std::int8_t GridMap::At(Vec2 point) const {
  const int column = static_cast<int>(std::floor((point.x - origin.x) / resolution));
  const int row = static_cast<int>(std::floor((point.y - origin.y) / resolution));
  if (column < 0 || column >= width || row < 0 || row >= height) return kUnknown;
  return cells[static_cast<std::size_t>(row) * width + column];
}

GridMap MakeGridMap(const Floor& floor, double resolution) {
  Painter painter(floor, resolution);
  for (const auto& wall : floor.walls) {
    for (std::size_t i = 1; i < wall.size(); ++i) painter.PaintLine({wall[i - 1], wall[i]});
  }
  for (const FloorBox& box : floor.furniture) painter.PaintOutline(box.shape);
  if (const auto landmark = LandmarkOf(floor)) {
    for (const Segment& side : SidesOf(*landmark)) painter.PaintLine(side);
  }
  painter.FillFree(floor.docked.position());
  for (const FloorBox& box : floor.furniture) {
    if (box.height < kSeen) painter.PaintOutline(box.shape, GridMap::kUnknown);
  }
  for (const Door& door : floor.doors) {
    if (const auto leaf = DoorLeaf(door, door.open)) painter.PaintLine(*leaf);
  }
  return std::move(painter.map());
}

}  // namespace coppice::robot::simulation
