// What the monitors watch, and how strictly: the file monitors.yaml as values.
#ifndef COPPICE_ROBOT_APP_MONITORING_MONITOR_CONFIG_H_
#define COPPICE_ROBOT_APP_MONITORING_MONITOR_CONFIG_H_

#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"
#include "robot_app/monitoring/system/system_watch.h"
#include "robot_app/monitoring/watch_list.h"

namespace coppice::robot::monitoring {

struct MonitorConfig {
  Duration report_period{0};        ///< of every monitor, wall time
  Duration patience{0};             ///< how long an error in ROS time is only a warning, wall time
  Duration ping_deadline{0};        ///< wall time
  Duration publish_period{0};       ///< of the aggregate, wall time
  Duration hold{0};                 ///< how long the aggregate shows the worst level at least
  int silent_periods = 3;           ///< a source that misses so many is silent
  Duration diagnostics_period{0};   ///< of /diagnostics, wall time; zero: it is not published
  std::string initial;              ///< configuration that counts while the supervisor is not heard
  std::vector<SystemWatch> system;  ///< of the computers, whatever the configuration
  std::vector<WatchList> lists;

  /// The computer of that name, else the one that stands for every computer, else null.
  const SystemWatch* ForHost(const std::string& host) const;

  /// An unknown configuration has an empty list.
  const WatchList& ForConfiguration(const std::string& name) const;
};

/// Reads and checks a file. Everything that is wrong is reported at once; with errors the result is
/// not to be used.
MonitorConfig LoadMonitorConfig(const std::string& path, Diagnostics& diagnostics);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_MONITOR_CONFIG_H_
