// A grid map: which cells of the floor are occupied, free or unknown.
// Values like nav_msgs/OccupancyGrid: row by row from the lower left corner, 0 free .. 100
// occupied, -1 unknown. The grid's axes are those of the map frame (no rotation).
#ifndef COPPICE_ROBOT_APP_COMMON_OCCUPANCY_GRID_H_
#define COPPICE_ROBOT_APP_COMMON_OCCUPANCY_GRID_H_

#include <cmath>
#include <cstdint>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot {

struct Cell {
  int x = 0;
  int y = 0;
  bool operator==(const Cell& other) const { return x == other.x && y == other.y; }
};

/// Size and place of a grid.
struct GridFrame {
  double resolution = 0.05;  ///< edge of a cell [m]
  double origin_x = 0;       ///< lower left corner of cell (0, 0) [m]
  double origin_y = 0;
  int width = 0;   ///< cells along x
  int height = 0;  ///< cells along y

  int size() const { return width * height; }
  bool Contains(Cell cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < width && cell.y < height;
  }
  int Index(Cell cell) const { return cell.y * width + cell.x; }
  Cell CellOf(int index) const { return {index % width, index / width}; }
  /// The cell of a point; may lie outside.
  Cell CellAt(double x, double y) const {
    return {static_cast<int>(std::floor((x - origin_x) / resolution)),
            static_cast<int>(std::floor((y - origin_y) / resolution))};
  }
  /// The middle of a cell [m].
  Point2D Center(Cell cell) const {
    return {origin_x + (cell.x + 0.5) * resolution, origin_y + (cell.y + 0.5) * resolution};
  }
};

struct OccupancyGrid {
  GridFrame frame;
  std::vector<std::int8_t> cells;  ///< frame.size() values

  /// Occupied from this value on; below it and not negative: free (map_server's threshold).
  static constexpr std::int8_t kOccupied = 65;

  /// Of the largest map that the robot uses: 250 m by 50 m at 0.05 m. Navigation takes 35 bytes for
  /// each.
  static constexpr std::int64_t kMostCells = 5'000'000;

  /// Unknown counts as blocked: nobody has looked there.
  bool Blocked(int index) const { return cells[index] < 0 || cells[index] >= kOccupied; }
};

/// A problem if the robot's programs have no room for a map of that size: more than kMostCells, or
/// longer than a kilometre, or more than 100 000 m^2 (localization searches all of it in squares of
/// 0.1 m, however large the cells are).
Outcome CheckSize(const GridFrame& frame);

/// The map, or of one for which there is no room the part that is known; a problem if that is too
/// large as well. (slam_gmapping draws 200 m by 200 m, whatever it knows of them.)
Expected<OccupancyGrid> WithRoom(OccupancyGrid map);

/// Distance of every cell's middle to the middle of the nearest cell with `blocked` != 0 [m];
/// 0 in blocked cells, `limit` where nothing is nearer than `limit`.
/// P. F. Felzenszwalb, D. P. Huttenlocher: Distance Transforms of Sampled Functions, Theory of
/// Computing 8 (2012): exact, linear in the number of cells.
std::vector<float> DistanceTransform(const GridFrame& frame,
                                     const std::vector<std::uint8_t>& blocked, double limit);

/// Calls `visit(cell)` for every cell that the segment from `a` to `b` [m] touches, in order, until
/// it returns false; true if it never did. Cells outside the grid are visited too.
/// J. Amanatides, A. Woo: A Fast Voxel Traversal Algorithm for Ray Tracing, Eurographics 1987.
template <typename Visit>
bool TraceLine(const GridFrame& frame, Point2D a, Point2D b, Visit visit) {
  Cell cell = frame.CellAt(a.x, a.y);
  const Cell last = frame.CellAt(b.x, b.y);
  const double dx = (b.x - a.x) / frame.resolution;
  const double dy = (b.y - a.y) / frame.resolution;
  const int step_x = dx > 0 ? 1 : -1;
  const int step_y = dy > 0 ? 1 : -1;
  const double in_x = (a.x - frame.origin_x) / frame.resolution - cell.x;
  const double in_y = (a.y - frame.origin_y) / frame.resolution - cell.y;
  // Fractions of the segment at which it crosses the next border, and between two borders.
  const double delta_x = dx != 0 ? 1 / std::abs(dx) : HUGE_VAL;
  const double delta_y = dy != 0 ? 1 / std::abs(dy) : HUGE_VAL;
  double next_x = dx != 0 ? (dx > 0 ? 1 - in_x : in_x) * delta_x : HUGE_VAL;
  double next_y = dy != 0 ? (dy > 0 ? 1 - in_y : in_y) * delta_y : HUGE_VAL;
  // The number of borders is known, so rounding cannot make the walk miss its end.
  int left = std::abs(last.x - cell.x) + std::abs(last.y - cell.y);
  if (!visit(cell)) return false;
  for (; left > 0; --left) {
    const bool along_x = cell.y == last.y || (cell.x != last.x && next_x < next_y);
    if (along_x) {
      cell.x += step_x;
      next_x += delta_x;
    } else {
      cell.y += step_y;
      next_y += delta_y;
    }
    if (!visit(cell)) return false;
  }
  return true;
}

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_OCCUPANCY_GRID_H_
