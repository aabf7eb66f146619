#include "robot_app/perception/clouds/clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coppice::robot::perception {
namespace {

// Cells of a picture that are waiting to be joined to something: a bit for each ring, so that
// columns in which nobody waits are passed at once.
class OpenCells {
 public:
  OpenCells(const RangeImage& image, const std::vector<Surface>& surfaces, float farthest)
      : image_(image), columns_(image.geometry.columns, 0) {
    for (std::size_t cell = 0; cell < image.size(); ++cell) {
      const bool is_open = surfaces[cell] == Surface::kStanding && image.ranges[cell] <= farthest;
      columns_[image.column(cell)] |= std::uint64_t{is_open} << image.ring(cell);
    }
  }

  bool Has(std::size_t cell) const {
    return (columns_[image_.column(cell)] >> image_.ring(cell) & 1) != 0;
  }
  /// Of one column, the rings `lowest` up to `highest`.
  std::uint64_t Between(std::size_t column, int lowest, int highest) const {
    return columns_[column] >> lowest << lowest & ~std::uint64_t{0} >> (63 - highest);
  }
  void Take(std::size_t cell, std::vector<std::uint32_t>& cells) {
    columns_[image_.column(cell)] &= ~(std::uint64_t{1} << image_.ring(cell));
    cells.push_back(static_cast<std::uint32_t>(cell));
  }

 private:
  const RangeImage& image_;
  std::vector<std::uint64_t> columns_;
};

// Floods the picture from each cell that is still open. `join(cell, cells)` takes those that belong
// to `cell`.
template <typename Join>
void Flood(OpenCells& open, std::size_t size, std::size_t least, Join join, Clusters& clusters) {
  clusters.clear();
  std::vector<std::uint32_t>& cells = clusters.cells;
  for (std::size_t seed = 0; seed < size; ++seed) {
    if (!open.Has(seed)) continue;
    const std::size_t first = cells.size();
    open.Take(seed, cells);
    for (std::size_t next = first; next < cells.size(); ++next) join(cells[next], cells);
    if (cells.size() - first < least) {
      cells.resize(first);
      continue;
    }
    std::sort(cells.begin() + static_cast<std::ptrdiff_t>(first), cells.end());
    clusters.Close();
  }
}

// The angle between the line through two points and the ray to the farther one.
float AngleBeta(float a, float b, float between) {
  const float far = std::max(a, b);
  const float near = std::min(a, b);
  return std::atan2(near * std::sin(between), far - near * std::cos(between));
}

}  // namespace

void ClusterByDepthSteps(const RangeImage& image, const std::vector<Surface>& surfaces,
                         const DepthStepOptions& options, Clusters& clusters) {
  OpenCells open(image, surfaces, std::numeric_limits<float>::infinity());
  const auto reach = [&](std::size_t from, int rings, int columns,
                         std::vector<std::uint32_t>& cells) {
    const float step_angle = rings != 0 ? image.geometry.ring_step : image.geometry.column_step();
    for (int step = 1; step <= options.reach; ++step) {
      const int ring = image.ring(from) + step * rings;
      if (ring < 0 || ring >= image.geometry.rings) return;
      const std::size_t to = image.cell(ring, image.column(from) + step * columns);
      if (image.ranges[to] <= 0) continue;  // a lost return
      const float between = static_cast<float>(step) * step_angle;
      if (open.Has(to) &&
          AngleBeta(image.ranges[from], image.ranges[to], between) > options.angle) {
        open.Take(to, cells);
      }
      return;
    }
  };
  const auto join = [&](std::size_t from, std::vector<std::uint32_t>& cells) {
    for (const int sign : {-1, 1}) {
      reach(from, 0, sign, cells);
      reach(from, sign, 0, cells);
    }
  };
  Flood(open, image.size(), options.least_cells, join, clusters);
}

void ClusterByDistance(const RangeImage& image, const std::vector<Surface>& surfaces,
                       const DistanceOptions& options, Clusters& clusters) {
  const LidarGeometry& geometry = image.geometry;
  const float ring_gap = options.ring_gaps * 2 * std::tan(geometry.ring_step / 2);
  OpenCells open(image, surfaces, options.farthest);
  const auto join = [&](std::size_t from, std::vector<std::uint32_t>& cells) {
    const float range = image.ranges[from];
    const float distance = options.least + ring_gap * range;
    // From there the distance is seen under this angle at most.
    const float angle = std::asin(std::min(1.0F, distance / std::max(range, distance)));
    const int columns =
        std::min(static_cast<int>(angle / geometry.column_step()) + 1, geometry.columns / 2 - 1);
    const int rings = static_cast<int>(angle / geometry.ring_step) + 1;
    const int lowest = std::max(0, image.ring(from) - rings);
    const int highest = std::min(geometry.rings - 1, image.ring(from) + rings);
    for (int column = image.column(from) - columns; column <= image.column(from) + columns;
         ++column) {
      const std::size_t bottom = image.cell(0, column);
      std::uint64_t waiting = open.Between(image.column(bottom), lowest, highest);
      for (std::size_t to = bottom; waiting != 0; ++to, waiting >>= 1) {
        if ((waiting & 1) != 0 &&
            (image.points[to] - image.points[from]).squaredNorm() <= distance * distance) {
          open.Take(to, cells);
        }
      }
    }
  };
  Flood(open, image.size(), options.least_cells, join, clusters);
}

}  // namespace coppice::robot::perception
