// How far it is to the charging station: as the navigation measures it on its map, and while that
// is silent, estimated.
#ifndef COPPICE_BT_NODES_POWER_WAY_HOME_H_
#define COPPICE_BT_NODES_POWER_WAY_HOME_H_

#include <optional>

#include "bt_core/base/clock.h"

namespace coppice::leaves {

class WayHome {
 public:
  /// The straight line times `detour` is the estimate.
  explicit WayHome(double detour = 1.5) : detour_(detour) {}

  /// The navigation has measured it [m]. Negative or not finite: not used.
  void OnMeasured(double way, Time now);

  /// The length of the way [m]: measured in the last three seconds, or estimated from the straight
  /// line to the station [m]. `now` is of the same clock and never goes back.
  double Length(double straight, Time now) const;

 private:
  double detour_;
  std::optional<double> measured_;
  Time measured_at_{};
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_POWER_WAY_HOME_H_
