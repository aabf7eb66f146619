// Casts rays against the segments of a floor, fast: the segments lie in a uniform grid and a ray
// visits only the cells on its way, nearest first (Amanatides and Woo, "A Fast Voxel Traversal
// Algorithm for Ray Tracing", Eurographics 1987).
#ifndef COPPICE_ROBOT_APP_SIMULATION_RAY_CASTER_H_
#define COPPICE_ROBOT_APP_SIMULATION_RAY_CASTER_H_

#include <cstdint>
#include <vector>

#include "robot_app/simulation/geometry.h"

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

class RayCaster {
 public:
  /// Sorts the segments into cells of `cell` metres. Build it anew when a door or a box has moved.
  explicit RayCaster(std::vector<Segment> segments = {}, double cell = 0.5);

  /// The range to the nearest segment, at most `max_range`. `direction` must have length 1. Const
  /// and without allocation, so any number of threads may cast.
  double Cast(Vec2 origin, Vec2 direction, double max_range) const;

  const std::vector<Segment>& segments() const { return segments_; }

 private:
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
  // Cell i holds the segments items_[begin_[i]] up to items_[begin_[i + 1]].
  std::vector<std::uint32_t> begin_;
  std::vector<Segment> items_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_RAY_CASTER_H_
