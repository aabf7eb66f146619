// What is measured of a computer, from what is written about it.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_GAUGES_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_GAUGES_H_

#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/system/system_watch.h"

namespace coppice::robot::monitoring {

/// The same with the names of what is there instead of patterns. `links`: of this computer. What is
/// also written by its name is as it is written there.
SystemWatch WithNames(const SystemWatch& watch, const std::vector<std::string>& links,
                      const std::vector<Computer>& others);

/// One number each. To be called WithNames.
std::vector<GaugeWatch> GaugesOf(const SystemWatch& watch);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_GAUGES_H_
