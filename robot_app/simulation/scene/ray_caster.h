// Casts rays against the segments of a floor, fast: the segments lie in a uniform grid and a ray
// visits only the cells on its way, nearest first (Amanatides and Woo, "A Fast Voxel Traversal
// Algorithm for Ray Tracing", Eurographics 1987).
#ifndef COPPICE_ROBOT_APP_SIMULATION_SCENE_RAY_CASTER_H_
#define COPPICE_ROBOT_APP_SIMULATION_SCENE_RAY_CASTER_H_

#include <cstdint>
#include <vector>

#include "robot_app/simulation/scene/geometry.h"

namespace coppice::robot::simulation {

/// A moving thing that a lidar sees as round.
struct Disc {
  Vec2 center;
  double radius = 0;
};

/// The range at which a ray from `origin` along the unit vector `direction` meets the segment or
/// the disc; `max_range` if it does not meet it before. From inside a disc the range is 0.
double CastAtSegment(const Segment& segment, Vec2 origin, Vec2 direction, double max_range);
double CastAtDisc(const Disc& disc, Vec2 origin, Vec2 direction, double max_range);

class RayCaster;

/// The cells of a RayCaster on the way of a ray, nearest first:
///
///   for (CellWalk walk(caster, origin, direction, 20); walk.inside(); walk.Next()) ...
class CellWalk {
 public:
  /// Ends where the ray leaves the grid or is longer than `max_range`.
  CellWalk(const RayCaster& caster, Vec2 origin, Vec2 direction, double max_range);

  bool inside() const { return inside_; }
  /// Which cell it is, for RayCaster::items().
  std::size_t cell() const { return static_cast<std::size_t>(row_) * columns_ + column_; }
  /// The range at which the ray leaves it.
  double border() const { return std::min(next_x_, next_y_); }
  void Next();

 private:
  bool inside_ = false;
  int column_ = 0, row_ = 0, columns_ = 0, rows_ = 0;
  int step_x_ = 0, step_y_ = 0;
  double next_x_ = 0, next_y_ = 0, per_cell_x_ = 0, per_cell_y_ = 0;
  double max_range_ = 0;
};

class RayCaster {
 public:
  /// Sorts the segments into cells of `cell` metres. Build it anew when a door or a box has moved.
  explicit RayCaster(std::vector<Segment> segments = {}, double cell = 0.5);

  /// The range to the nearest segment, at most `max_range`. `direction` must have length 1. Const
  /// and without allocation, so any number of threads may cast.
  double Cast(Vec2 origin, Vec2 direction, double max_range) const;

  const std::vector<Segment>& segments() const { return segments_; }

  /// Those that pass a cell, by their index. One that passes many cells is in each of them.
  struct Items {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };
  Items items(std::size_t cell) const {
    return {indices_.data() + begin_[cell], indices_.data() + begin_[cell + 1]};
  }

 private:
  friend class CellWalk;

  int Column(double x) const { return static_cast<int>(std::floor((x - low_.x) / cell_)); }
  int Row(double y) const { return static_cast<int>(std::floor((y - low_.y) / cell_)); }
  void FindBounds();
  void FillCells();
  template <typename Visitor>
  void ForEachCell(const Segment& segment, Visitor visit) const;

  std::vector<Segment> segments_;
  double cell_;
  Vec2 low_;
  Vec2 high_;
  int columns_ = 0;
  int rows_ = 0;
  // Cell i holds the segments items_[begin_[i]] up to items_[begin_[i + 1]]; indices_ says which
  // they are.
  std::vector<std::uint32_t> begin_;
  std::vector<Segment> items_;
  std::vector<std::uint32_t> indices_;
};

inline void CellWalk::Next() {
  if (border() >= max_range_) {
    inside_ = false;
  } else if (next_x_ < next_y_) {
    column_ += step_x_;
    next_x_ += per_cell_x_;
    inside_ = column_ >= 0 && column_ < columns_;
  } else {
    row_ += step_y_;
    next_y_ += per_cell_y_;
    inside_ = row_ >= 0 && row_ < rows_;
  }
}

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SCENE_RAY_CASTER_H_
