#include "robot_app/common/occupancy_grid.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace coppice::robot {
namespace {

/// The lower envelope of parabolas, the one-dimensional transform of the paper. Cells of the height
/// `far` raise none. Buffers are kept between lines.
class Envelope {
 public:
  Envelope(int longest, float far)
      : far_(far), place_(longest), height_(longest), border_(longest + 1) {}

  /// Replaces `count` squared distances, at most far, by their transform.
  void Transform(float* line, int count) {
    int parabolas = 0;
    for (int q = 0; q < count; ++q) {
      if (line[q] >= far_) continue;
      float from = -kEverywhere;
      while (parabolas > 0) {
        from = Crossing(line, q, place_[parabolas - 1]);
        if (from > border_[parabolas - 1]) break;
        if (--parabolas == 0) from = -kEverywhere;
      }
      place_[parabolas] = q;
      height_[parabolas] = line[q];
      border_[parabolas++] = from;
    }
    if (parabolas == 0) return;
    border_[parabolas] = kEverywhere;
    for (int q = 0, k = 0; q < count; ++q) {
      while (border_[k + 1] < static_cast<float>(q)) ++k;
      const auto apart = static_cast<float>(q - place_[k]);
      line[q] = std::min(far_, apart * apart + height_[k]);
    }
  }

 private:
  static constexpr float kEverywhere = 1e18F;

  static float Crossing(const float* line, int q, int p) {
    const auto fq = static_cast<float>(q);
    const auto fp = static_cast<float>(p);
    return ((line[q] + fq * fq) - (line[p] + fp * fp)) / (2 * fq - 2 * fp);
  }

  const float far_;
  std::vector<int> place_;
  std::vector<float> height_;
  std::vector<float> border_;  // from where on each is the lowest
};

/// Cells up or down to the nearest blocked one of the same column, at most `most`. All columns at a
/// time, row by row.
std::vector<float> AlongColumns(const GridFrame& frame, const std::vector<std::uint8_t>& blocked,
                                float most) {
  std::vector<float> apart(frame.size(), most);
  for (int i = 0; i < frame.size(); ++i) {
    const float before = i < frame.width ? most : apart[i - frame.width];
    apart[i] = blocked[i] != 0 ? 0 : std::min(most, before + 1);
  }
  for (int i = frame.size() - frame.width - 1; i >= 0; --i) {
    apart[i] = std::min(apart[i], apart[i + frame.width] + 1);
  }
  return apart;
}

constexpr double kLongest = 1000;     // m
constexpr double kLargestArea = 1e5;  // m^2

OccupancyGrid KnownPart(const OccupancyGrid& map) {
  Cell low{map.frame.width, map.frame.height}, high{-1, -1};
  for (int i = 0; i < map.frame.size(); ++i) {
    if (map.cells[i] < 0) continue;
    const Cell cell = map.frame.CellOf(i);
    low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
    high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
  }
  OccupancyGrid part;
  part.frame = map.frame;
  part.frame.origin_x += low.x * map.frame.resolution;
  part.frame.origin_y += low.y * map.frame.resolution;
  part.frame.width = std::max(0, high.x - low.x + 1);
  part.frame.height = std::max(0, high.y - low.y + 1);
  if (!CheckSize(part.frame)) return part;
  for (int y = low.y; y <= high.y; ++y) {
    const auto row = map.cells.begin() + map.frame.Index({low.x, y});
    part.cells.insert(part.cells.end(), row, row + part.frame.width);
  }
  return part;
}

}  // namespace

Outcome CheckSize(const GridFrame& frame) {
  const double wide = frame.width * frame.resolution, high = frame.height * frame.resolution;
  const bool has_room = std::int64_t{frame.width} * frame.height <= OccupancyGrid::kMostCells &&
                        wide <= kLongest && high <= kLongest && wide * high <= kLargestArea;
  if (has_room) return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "the map has %d x %d cells of %g m; expected at most %d cells, %g m and %g m^2",
                frame.width, frame.height, frame.resolution,
                static_cast<int>(OccupancyGrid::kMostCells), kLongest, kLargestArea);
  return Problem{text};
}

Expected<OccupancyGrid> WithRoom(OccupancyGrid map) {
  if (CheckSize(map.frame)) return map;
  OccupancyGrid part = KnownPart(map);
  if (part.cells.empty()) return Problem{CheckSize(map.frame).problem()};
  return part;
}

std::vector<float> DistanceTransform(const GridFrame& frame,
                                     const std::vector<std::uint8_t>& blocked, double limit) {
  // Farther than any limit is not told apart.
  const auto limit_cells = static_cast<float>(std::ceil(limit / frame.resolution) + 1);
  std::vector<float> squared = AlongColumns(frame, blocked, limit_cells);
  for (float& value : squared) value *= value;
  Envelope envelope(frame.width, limit_cells * limit_cells);
  for (int y = 0; y < frame.height; ++y) {
    envelope.Transform(squared.data() + static_cast<std::ptrdiff_t>(y) * frame.width, frame.width);
  }
  const auto resolution = static_cast<float>(frame.resolution);
  for (float& value : squared) {
    value = std::min(std::sqrt(value) * resolution, static_cast<float>(limit));
  }
  return squared;
}

}  // namespace coppice::robot
