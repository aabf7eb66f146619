// One reading of a sensor that tells how far the nearest thing in its cone is, and not where in the
// cone: ultrasound. As sensor_msgs/Range, with REP-117's words for what cannot be measured.
#ifndef COPPICE_ROBOT_APP_COMMON_RANGE_READING_H_
#define COPPICE_ROBOT_APP_COMMON_RANGE_READING_H_

#include <cmath>

#include "bt_core/base/outcome.h"
#include "robot_app/common/pose2d.h"

namespace coppice::robot {

struct RangeReading {
  double stamp = 0;               ///< time of the measurement [s]
  Pose2D mount;                   ///< the sensor in base_link
  double field_of_view = 0.5236;  ///< of the whole cone [rad]
  double min_range = 0.2;         ///< [m]
  double max_range = 4;           ///< [m]
  double range = 0;               ///< [m]; see below for what is no number of metres

  bool Hit() const { return range >= min_range && range <= max_range; }
  bool MetNothing() const { return range == HUGE_VAL; }
  bool TooNear() const { return range == -HUGE_VAL; }  ///< something nearer than min_range
};

/// Why a reading tells nothing, for people: its range is none of the three above, or the cone or
/// its limits cannot be those of a sensor.
inline Outcome Check(const RangeReading& reading) {
  const bool is_cone = reading.field_of_view > 0 && reading.field_of_view <= M_PI;
  if (!is_cone) return Problem{"its field of view is none"};
  const bool has_limits = reading.min_range >= 0 && reading.max_range > reading.min_range &&
                          std::isfinite(reading.max_range);
  if (!has_limits) return Problem{"its least and greatest range make no sense"};
  if (reading.Hit() || reading.MetNothing() || reading.TooNear()) return {};
  if (std::isnan(reading.range)) return Problem{"the range is not a number"};
  return Problem{"the range is outside the sensor's limits"};
}

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_RANGE_READING_H_
