// Makes a map of the institute, driven through once with people about, and draws it with the way of
// the robot (PNG):
//   build/tests/bin/draw_map docs/pictures/map.png
// White: free, black: occupied, grey: unknown, blue: the way.
#include <cstdio>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "tests/robot_app/mapping/mapped_robot.h"

namespace coppice::robot::mapping {
namespace {

struct Color {
  std::uint8_t red, green, blue;
};

class Picture {
 public:
  explicit Picture(const OccupancyGrid& map) : frame_(map.frame), pixels_(map.frame.size()) {
    for (int i = 0; i < frame_.size(); ++i) {
      const std::int8_t cell = map.cells[i];
      const std::uint8_t gray = cell < 0 ? 205 : cell >= OccupancyGrid::kOccupied ? 0 : 255;
      At(frame_.CellOf(i)) = {gray, gray, gray};
    }
  }

  void Dot(const Point2D& point, Color color) {
    const Cell middle = frame_.CellAt(point.x, point.y);
    for (int i = 0; i < 9; ++i) {
      const Cell cell{middle.x + i % 3 - 1, middle.y + i / 3 - 1};
      if (frame_.Contains(cell)) At(cell) = color;
    }
  }

  bool Write(const char* file) const {
    return stbi_write_png(file, frame_.width, frame_.height, 3, pixels_.data(), 3 * frame_.width) !=
           0;
  }

 private:
  // Pictures begin at the upper left corner.
  Color& At(Cell cell) { return pixels_[frame_.Index({cell.x, frame_.height - 1 - cell.y})]; }

  GridFrame frame_;
  std::vector<Color> pixels_;
};

int Draw(const char* file) {
  MappedRobot robot(navigation::InstituteFloor(), {-0.5, 0, 0}, 1);
  std::vector<Point2D> way;
  Tour tour(RoundOfTheInstitute());
  while (const auto command = tour.Next(robot.Truth())) {
    robot.Step(*command);
    way.push_back({robot.Truth().x, robot.Truth().y});
  }
  const MappingReport report = robot.mapper().Report();
  std::printf("%.0f m, %zu key frames, %zu closed loops; never farther off than %.3f m\n",
              report.way, report.key_frames, report.loops, robot.farthest_off());
  Picture picture(robot.mapper().Map());
  for (std::size_t i = 0; i < way.size(); i += 20) picture.Dot(way[i], {40, 110, 220});
  return picture.Write(file) ? 0 : 1;
}

}  // namespace
}  // namespace coppice::robot::mapping

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: draw_map PICTURE.png\n");
    return 2;
  }
  return coppice::robot::mapping::Draw(argv[1]);
}
