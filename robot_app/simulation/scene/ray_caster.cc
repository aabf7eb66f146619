#include "robot_app/simulation/scene/ray_caster.h"

#include <limits>
#include <utility>

namespace coppice::robot::simulation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMargin = 1e-3;  // a segment on the border of two cells belongs to both

// The part [from, to] of the ray that lies between two parallel lines.
void ClipAxis(double origin, double direction, double low, double high, double& from, double& to) {
  if (direction == 0) {
    if (origin < low || origin > high) to = -1;
    return;
  }
  double a = (low - origin) / direction;
  double b = (high - origin) / direction;
  if (a > b) std::swap(a, b);
  from = std::max(from, a);
  to = std::min(to, b);
}

}  // namespace

double CastAtSegment(const Segment& segment, Vec2 origin, Vec2 direction, double max_range) {
  const Vec2 along = segment.b - segment.a;
  const Vec2 to_a = segment.a - origin;
  const double denominator = Cross(direction, along);
  if (denominator == 0) return max_range;  // parallel: seen end-on, it has no width
  const double range = Cross(to_a, along) / denominator;
  const double part = Cross(to_a, direction) / denominator;
  return range >= 0 && range < max_range && part >= 0 && part <= 1 ? range : max_range;
}

double CastAtDisc(const Disc& disc, Vec2 origin, Vec2 direction, double max_range) {
  const Vec2 to_center = disc.center - origin;
  const double along = Dot(to_center, direction);
  const double gap = Dot(to_center, to_center) - disc.radius * disc.radius;
  if (gap <= 0) return 0;
  const double discriminant = along * along - gap;
  if (along <= 0 || discriminant < 0) return max_range;
  return std::min(max_range, along - std::sqrt(discriminant));
}

RayCaster::RayCaster(std::vector<Segment> segments, double cell)
    : segments_(std::move(segments)), cell_(cell) {
  if (segments_.empty()) return;
  FindBounds();
  FillCells();
}

void RayCaster::FindBounds() {
  low_ = {kInfinity, kInfinity};
  high_ = {-kInfinity, -kInfinity};
  for (const Segment& s : segments_) {
    low_ = {std::min({low_.x, s.a.x, s.b.x}), std::min({low_.y, s.a.y, s.b.y})};
    high_ = {std::max({high_.x, s.a.x, s.b.x}), std::max({high_.y, s.a.y, s.b.y})};
  }
  low_ = low_ - Vec2{2 * kMargin, 2 * kMargin};
  columns_ = Column(high_.x + 2 * kMargin) + 1;
  rows_ = Row(high_.y + 2 * kMargin) + 1;
  high_ = low_ + Vec2{columns_ * cell_, rows_ * cell_};
}

// Visits the cells that a segment passes, row by row: in each row the columns between the points
// where the segment enters and leaves it.
template <typename Visitor>
void RayCaster::ForEachCell(const Segment& s, Visitor visit) const {
  const Segment up = s.a.y <= s.b.y ? s : Segment{s.b, s.a};
  const double height = up.b.y - up.a.y;
  const int last_row = Row(up.b.y + kMargin);
  for (int row = Row(up.a.y - kMargin); row <= last_row; ++row) {
    double left = std::min(up.a.x, up.b.x);
    double right = std::max(up.a.x, up.b.x);
    if (height > kMargin) {
      const double enter = (low_.y + row * cell_ - kMargin - up.a.y) / height;
      const double leave = (low_.y + (row + 1) * cell_ + kMargin - up.a.y) / height;
      const double x0 = up.a.x + (up.b.x - up.a.x) * std::clamp(enter, 0.0, 1.0);
      const double x1 = up.a.x + (up.b.x - up.a.x) * std::clamp(leave, 0.0, 1.0);
      left = std::min(x0, x1);
      right = std::max(x0, x1);
    }
    const int last_column = Column(right + kMargin);
    for (int column = Column(left - kMargin); column <= last_column; ++column) {
      visit(static_cast<std::size_t>(row) * columns_ + column);
    }
  }
}

void RayCaster::FillCells() {
  begin_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Segment& s : segments_) {
    ForEachCell(s, [this](std::size_t cell) { ++begin_[cell + 1]; });
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  items_.resize(begin_.back());
  indices_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t index = 0; index < segments_.size(); ++index) {
    ForEachCell(segments_[index], [&](std::size_t cell) {
      items_[next[cell]] = segments_[index];
      indices_[next[cell]++] = index;
    });
  }
}

CellWalk::CellWalk(const RayCaster& caster, Vec2 origin, Vec2 direction, double max_range)
    : columns_(caster.columns_), rows_(caster.rows_), max_range_(max_range) {
  double from = 0;
  double to = max_range;
  ClipAxis(origin.x, direction.x, caster.low_.x, caster.high_.x, from, to);
  ClipAxis(origin.y, direction.y, caster.low_.y, caster.high_.y, from, to);
  if (caster.segments_.empty() || from > to) return;

  inside_ = true;
  const Vec2 start = origin + direction * from;
  const double cell = caster.cell_;
  column_ = std::clamp(caster.Column(start.x), 0, columns_ - 1);
  row_ = std::clamp(caster.Row(start.y), 0, rows_ - 1);
  step_x_ = direction.x > 0 ? 1 : -1;
  step_y_ = direction.y > 0 ? 1 : -1;
  const double border_x = caster.low_.x + (column_ + (step_x_ > 0)) * cell;
  const double border_y = caster.low_.y + (row_ + (step_y_ > 0)) * cell;
  next_x_ = direction.x != 0 ? (border_x - origin.x) / direction.x : kInfinity;
  next_y_ = direction.y != 0 ? (border_y - origin.y) / direction.y : kInfinity;
  per_cell_x_ = direction.x != 0 ? cell / std::abs(direction.x) : kInfinity;
  per_cell_y_ = direction.y != 0 ? cell / std::abs(direction.y) : kInfinity;
}

double RayCaster::Cast(Vec2 origin, Vec2 direction, double max_range) const {
  double nearest = max_range;
  for (CellWalk walk(*this, origin, direction, max_range); walk.inside(); walk.Next()) {
    const std::uint32_t last = begin_[walk.cell() + 1];
    for (std::uint32_t i = begin_[walk.cell()]; i < last; ++i) {
      nearest = CastAtSegment(items_[i], origin, direction, nearest);
    }
    if (nearest <= walk.border()) break;
  }
  return nearest;
}

}  // namespace coppice::robot::simulation
