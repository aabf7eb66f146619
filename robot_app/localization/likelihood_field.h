// The map as a laser sees it: how far every point is from the nearest wall, and how far a beam
// goes. S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics (2005), ch. 6.4 (likelihood fields).
// All in the map frame, in metres. Const after construction, so any number of threads may ask.
#ifndef COPPICE_ROBOT_APP_LOCALIZATION_LIKELIHOOD_FIELD_H_
#define COPPICE_ROBOT_APP_LOCALIZATION_LIKELIHOOD_FIELD_H_

#include <vector>

#include "robot_app/common/occupancy_grid.h"

namespace coppice::robot::localization {

class LikelihoodField {
 public:
  static constexpr double kReach = 2.0;  ///< farther from a wall is not told apart [m]

  explicit LikelihoodField(const OccupancyGrid& map);

  const GridFrame& frame() const { return frame_; }
  /// The robot may stand here: the cell is free. False outside of the map.
  bool Free(double x, double y) const;
  /// To the nearest occupied cell's middle, at most kReach; kReach outside of the map.
  float Distance(double x, double y) const {
    const Cell cell = frame_.CellAt(x, y);
    return frame_.Contains(cell) ? distance_[frame_.Index(cell)] : static_cast<float>(kReach);
  }
  /// The same between the cells, with its slope (bilinear).
  struct Slope {
    double distance = kReach;
    double along_x = 0;
    double along_y = 0;
  };
  Slope DistanceAndSlope(double x, double y) const;

  /// Way from `from` towards `to` up to the first occupied cell; HUGE_VAL if there is none before
  /// `to`. By sphere tracing (J. C. Hart, The Visual Computer 12, 1996): no step is longer than the
  /// distance to the nearest wall.
  double Cast(const Point2D& from, const Point2D& to) const;

 private:
  GridFrame frame_;
  std::vector<bool> free_;
  std::vector<float> distance_;
};

}  // namespace coppice::robot::localization

#endif  // COPPICE_ROBOT_APP_LOCALIZATION_LIKELIHOOD_FIELD_H_
