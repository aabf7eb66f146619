#include "robot_app/mapping/log_odds_grid.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::mapping {
namespace {

constexpr float kHit = 0.85F;      // p = 0.7
constexpr float kMiss = -0.4F;     // p = 0.4
constexpr float kMost = 3.5F;      // p = 0.97; so that what has changed is believed in the end
constexpr float kLeast = -2.0F;    // p = 0.12
constexpr int kChunk = 128;        // cells; the grid grows by whole ones
constexpr double kFarthest = 1e5;  // m; of the robot from the origin
constexpr int kBorder = 10;        // unknown cells around what is known
// A beam that grazes a wall goes through its cells before it ends there: the last part of its way
// says nothing.
constexpr double kClearShare = 0.975;
constexpr double kClearLess = 0.05;  // m

int ChunksDown(double cells) { return static_cast<int>(std::floor(cells / kChunk)) * kChunk; }

}  // namespace

bool LogOddsGrid::Cover(const Point2D& middle, double range) {
  if (!(std::abs(middle.x) + std::abs(middle.y) < kFarthest)) return false;
  // Half a cell off, so that the origin of the map frame lies in the middle of a cell.
  const double size = frame_.resolution;
  int low_x = ChunksDown((middle.x - range) / size + 0.5);
  int low_y = ChunksDown((middle.y - range) / size + 0.5);
  int high_x = ChunksDown((middle.x + range) / size + 0.5) + kChunk;
  int high_y = ChunksDown((middle.y + range) / size + 0.5) + kChunk;
  const int old_x = static_cast<int>(std::lround(frame_.origin_x / size + 0.5));
  const int old_y = static_cast<int>(std::lround(frame_.origin_y / size + 0.5));
  if (!values_.empty()) {
    low_x = std::min(low_x, old_x);
    low_y = std::min(low_y, old_y);
    high_x = std::max(high_x, old_x + frame_.width);
    high_y = std::max(high_y, old_y + frame_.height);
  }
  GridFrame grown = frame_;
  grown.origin_x = (low_x - 0.5) * size;
  grown.origin_y = (low_y - 0.5) * size;
  grown.width = high_x - low_x;
  grown.height = high_y - low_y;
  if (!CheckSize(grown)) return false;
  if (grown.width == frame_.width && grown.height == frame_.height) return true;
  std::vector<Value> values(grown.size());
  for (int y = 0; y < frame_.height; ++y) {
    const auto row = values_.begin() + static_cast<std::ptrdiff_t>(y) * frame_.width;
    std::copy(row, row + frame_.width,
              values.begin() + grown.Index({old_x - low_x, old_y - low_y + y}));
  }
  frame_ = grown;
  values_ = std::move(values);
  return true;
}

void LogOddsGrid::Count(Cell cell, float change) {
  if (!frame_.Contains(cell)) return;
  Value& value = values_[frame_.Index(cell)];
  if (value.scan == scans_) return;
  value.scan = scans_;
  value.log_odds = std::clamp(value.log_odds + change, kLeast, kMost);
}

bool LogOddsGrid::Add(const LaserScan& scan, const Pose2D& pose, double range) {
  const Pose2D scanner = Compose(pose, scan.mount);
  const Point2D from{scanner.x, scanner.y};
  if (!std::isfinite(scanner.yaw) || !Cover(from, range)) return false;
  ++scans_;
  const auto point = [&](std::size_t i, double distance) {
    const double angle =
        scanner.yaw + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    return Point2D{from.x + distance * std::cos(angle), from.y + distance * std::sin(angle)};
  };
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (!scan.Hit(i) || scan.ranges[i] > range) continue;
    const Point2D end = point(i, scan.ranges[i]);
    Count(frame_.CellAt(end.x, end.y), kHit);
  }
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double reading = scan.ranges[i];
    if (!(reading >= scan.range_min)) continue;  // not a number, or too near to be an echo
    const double free = std::min(range, reading * kClearShare - kClearLess);
    if (free <= 0) continue;
    TraceLine(frame_, from, point(i, free), [this](Cell cell) {
      Count(cell, kMiss);
      return true;
    });
  }
  return true;
}

GridFrame LogOddsGrid::KnownPart() const {
  Cell low{frame_.width, frame_.height};
  Cell high{-1, -1};
  for (int i = 0; i < frame_.size(); ++i) {
    if (values_[i].scan == 0) continue;
    const Cell cell = frame_.CellOf(i);
    low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
    high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
  }
  GridFrame part = frame_;
  if (high.x < 0) return part;
  low = {std::max(low.x - kBorder, 0), std::max(low.y - kBorder, 0)};
  high = {std::min(high.x + kBorder, frame_.width - 1),
          std::min(high.y + kBorder, frame_.height - 1)};
  part.origin_x += low.x * frame_.resolution;
  part.origin_y += low.y * frame_.resolution;
  part.width = high.x - low.x + 1;
  part.height = high.y - low.y + 1;
  return part;
}

OccupancyGrid LogOddsGrid::ToMap() const {
  OccupancyGrid map;
  map.frame = KnownPart();
  map.cells.resize(map.frame.size(), -1);
  const int off_x =
      static_cast<int>(std::lround((map.frame.origin_x - frame_.origin_x) / frame_.resolution));
  const int off_y =
      static_cast<int>(std::lround((map.frame.origin_y - frame_.origin_y) / frame_.resolution));
  for (int i = 0; i < map.frame.size(); ++i) {
    const Cell cell = map.frame.CellOf(i);
    const Value& value = values_[frame_.Index({cell.x + off_x, cell.y + off_y})];
    if (value.scan == 0) continue;
    const double odds = std::exp(value.log_odds);
    map.cells[i] = static_cast<std::int8_t>(std::lround(100 * odds / (1 + odds)));
  }
  return map;
}

}  // namespace coppice::robot::mapping
