// Draws a floor with its map, a robot and what its lidar sees as a picture (PPM, 20 pixels a
// metre):
//   draw_floor FLOOR.yaml X Y YAW SECONDS > picture.ppm
// White: free, black: occupied, grey: unknown. Red: lidar hits, blue: robot, green: people after
// SECONDS, magenta: waypoints.
#include <cstdio>
#include <cstdlib>

#include "robot_app/simulation/grid_map.h"
#include "robot_app/simulation/world.h"

namespace coppice::robot::simulation {
namespace {

struct Color {
  unsigned char red, green, blue;
};

class Picture {
 public:
  explicit Picture(const GridMap& map) : map_(map) {
    for (const std::int8_t cell : map.cells) {
      const unsigned char grey = cell == GridMap::kFree       ? 255
                                 : cell == GridMap::kOccupied ? 0
                                                              : 160;
      pixels_.push_back({grey, grey, grey});
    }
  }

  void Disc(Vec2 center, double radius, Color color) {
    for (double y = -radius; y <= radius; y += map_.resolution / 2) {
      for (double x = -radius; x <= radius; x += map_.resolution / 2) {
        if (std::hypot(x, y) <= radius) Dot(center + Vec2{x, y}, color);
      }
    }
  }

  void Dot(Vec2 p, Color color) {
    const int column = static_cast<int>((p.x - map_.origin.x) / map_.resolution);
    const int row = static_cast<int>((p.y - map_.origin.y) / map_.resolution);
    if (column < 0 || row < 0 || column >= map_.width || row >= map_.height) return;
    pixels_[static_cast<std::size_t>(row) * map_.width + column] = color;
  }

  void Write() const {
    std::printf("P6\n%d %d\n255\n", map_.width, map_.height);
    for (int row = map_.height - 1; row >= 0; --row) {
      std::fwrite(&pixels_[static_cast<std::size_t>(row) * map_.width], 3, map_.width, stdout);
    }
  }

 private:
  const GridMap& map_;
  std::vector<Color> pixels_;
};

int Draw(const Floor& floor, const Pose2& start, double seconds) {
  WorldOptions options;
  options.start = start;
  World world(floor, options);
  while (world.time() < seconds) world.Step(0.02);
  const GridMap map = MakeGridMap(floor, floor.resolution);
  Picture picture(map);
  for (const FloorWaypoint& w : floor.waypoints)
    picture.Disc(w.pose.position(), 0.1, {255, 0, 255});
  for (const Disc& person : world.people()) {
    picture.Disc(person.center, person.radius, {0, 160, 0});
  }
  picture.Disc(world.robot().position(), kRobotRadius, {0, 0, 255});
  const Pose2 laser = Compose(world.robot(), options.lidar.mounting);
  const Scan& scan = world.scan();
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = laser.yaw + scan.angle_min + static_cast<double>(i) * scan.angle_step;
    if (std::isfinite(scan.ranges[i])) {
      picture.Disc(laser.position() + Direction(angle) * scan.ranges[i], 0.05, {255, 0, 0});
    }
  }
  picture.Write();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::simulation

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: draw_floor FLOOR.yaml X Y YAW SECONDS > picture.ppm\n");
    return 2;
  }
  coppice::Diagnostics diagnostics;
  const auto floor = coppice::robot::simulation::LoadFloor(argv[1], diagnostics);
  if (!floor) return std::fputs(diagnostics.ToString().c_str(), stderr), 1;
  return coppice::robot::simulation::Draw(
      *floor, {std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4])}, std::atof(argv[5]));
}
