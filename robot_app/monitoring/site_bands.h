// What is judged otherwise at each site: the file bands.yaml in its folder. What it does not name
// is judged as monitors.yaml says.
//
//   navigation: {blocked: 120, no_path: 60, after_failure: 15}    # s
//   localization: {since_confirmed: {warn: [none, 30]}, score: {warn: [0.15, none]},
//                  deviation: {warn: [none, 1.5]}}
//   map_jump: {warn: [none, 3]}                                   # m, of map -> odom
//   dock: {places: places.yaml, way: /navigation/way_to_station}  # of the battery's margin
//
// It holds in every configuration that has such a section; a band that is named replaces the whole.
#ifndef COPPICE_ROBOT_APP_MONITORING_SITE_BANDS_H_
#define COPPICE_ROBOT_APP_MONITORING_SITE_BANDS_H_

#include <string>

#include "bt_core/base/diagnostic.h"
#include "robot_app/monitoring/monitor_config.h"

namespace coppice::robot::monitoring {

/// Reads a site's bands into `config`. With errors it is not to be used.
void ReadSiteBands(const std::string& path, MonitorConfig& config, Diagnostics& diagnostics);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SITE_BANDS_H_
