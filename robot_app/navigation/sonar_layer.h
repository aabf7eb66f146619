// What the ultrasonic sensors hear and the laser does not see: glass, and what is too low for it.
//
// An echo comes from somewhere on the arc at its range, so the whole arc is marked; not if the
// laser has seen something in the cone at about that range, because then it is that, and the laser
// knows better where it is. What lies in the cone nearer than the echo is free, and what was marked
// there is cleared; of the laser's obstacles nothing is. But a pane is silent to who looks at it at
// a slant, so that only what is heard from about the same direction refutes a mark. Marks that are
// not heard again fade.
// After the range_sensor_layer of ROS (D. V. Lu). Not thread-safe.
#ifndef COPPICE_ROBOT_APP_NAVIGATION_SONAR_LAYER_H_
#define COPPICE_ROBOT_APP_NAVIGATION_SONAR_LAYER_H_

#include <vector>

#include "robot_app/common/range_reading.h"
#include "robot_app/navigation/marked_cells.h"

namespace coppice::robot::navigation {

struct SonarSettings {
  double mark_range = 1.5;     ///< echoes from farther away have too wide an arc to mark [m]
  double forget_after = 10;    ///< marks not heard again are dropped after this time [s]
  double same_side = 0.3;      ///< silence refutes echoes from so near to its direction [rad]
  double oldest = 0.5;         ///< readings that are older when they come are refused [s]
  double seen_nearer = 0.3;    ///< so much nearer than the echo may be what the laser saw [m]
  double seen_farther = 0.15;  ///< ... and so much farther: clothes and legs, noise, movement [m]
};

class SonarLayer {
 public:
  explicit SonarLayer(SonarSettings settings = {}) : settings_(settings) {}

  /// Starts empty on a grid.
  void Reset(const GridFrame& frame);

  /// Enters a reading taken at `pose` (base_link in the map frame) that comes at `now` [s]. `seen`:
  /// what the laser hit lately, in the map frame. A problem if the reading is refused: it tells
  /// nothing (range_reading.h), or its stamp is old or of the future.
  Outcome Insert(const Pose2D& pose, const RangeReading& reading, const std::vector<Point2D>& seen,
                 double now);

  /// Drops marks that are older than `forget_after` at `now` [s], as Insert() does.
  void Forget(double now) { marks_.Forget(now, settings_.forget_after); }
  bool Marked(int index) const { return marks_.Marked(index); }
  /// The marked cells, in no particular order.
  const std::vector<int>& marked() const { return marks_.list(); }
  /// Adds the middles of those within `limit` [m] of `pose`, in its frame.
  void AddPoints(const Pose2D& pose, double limit, std::vector<Point2D>& points) const;

 private:
  bool IsSeen(const Pose2D& sensor, const RangeReading& reading,
              const std::vector<Point2D>& seen) const;
  void ClearNearer(const Pose2D& sensor, double half_cone, double range);
  void MarkArc(const Pose2D& sensor, const RangeReading& reading);

  SonarSettings settings_;
  MarkedCells marks_;
  std::vector<float> heading_;  // per marked cell: of the sound that came back, in the map [rad]
};

}  // namespace coppice::robot::navigation

#endif  // COPPICE_ROBOT_APP_NAVIGATION_SONAR_LAYER_H_
