// What the monitors watch, and how strictly: the file monitors.yaml as values.
#ifndef COPPICE_ROBOT_APP_MONITORING_MONITOR_CONFIG_H_
#define COPPICE_ROBOT_APP_MONITORING_MONITOR_CONFIG_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"

namespace coppice::robot {

struct NodeWatch {
  std::string node;
  int misses = 2;  ///< so many silent pings in a row are an error, fewer a warning
};

/// Bounds of a rate in Hz. A rate exactly on a bound is still within it; no bound, no alarm.
struct RateBand {
  std::optional<double> low, high;
};

struct TopicWatch {
  std::string topic;
  std::string node;  ///< its publisher, to be restarted
  RateBand warn, error;
  Duration window{0};      ///< over which the rate is measured
  Duration staleness{0};   ///< no message for longer than this is an error
  bool wall_time = false;  ///< rate, window and staleness in wall time instead of ROS time
};

struct NavigationWatch {
  std::string topic;
  std::string node;       ///< the navigation server
  Duration blocked{0};    ///< BLOCKED for longer than this is an error
  Duration no_path{0};    ///< NO_PATH for longer than this is an error
  Duration staleness{0};  ///< no state for longer than this is an error of the topic
  Duration after_failure{
      0};  ///< a goal that failed is an error for so long while nobody tries again
};

struct SourceWatch {
  std::string source;  ///< node of a monitor
  Duration period{0};  ///< at which it reports
};

/// What is watched in one configuration of the robot.
struct WatchList {
  std::string configuration;
  std::vector<NodeWatch> nodes;
  std::vector<TopicWatch> topics;
  std::optional<NavigationWatch> navigation;
  std::vector<SourceWatch> sources;
};

struct MonitorConfig {
  Duration report_period{0};   ///< of every monitor, wall time
  Duration patience{0};        ///< how long an error in ROS time is only a warning, wall time
  Duration ping_deadline{0};   ///< wall time
  Duration publish_period{0};  ///< of the aggregate, wall time
  Duration hold{0};            ///< how long the aggregate shows the worst level at least
  int silent_periods = 3;      ///< a source that misses so many is silent
  std::string initial;         ///< configuration that counts while the supervisor is not heard
  std::vector<WatchList> lists;

  /// An unknown configuration has an empty list.
  const WatchList& ForConfiguration(const std::string& name) const;
};

/// Reads and checks a file. Everything that is wrong is reported at once; with errors the result is
/// not to be used.
MonitorConfig LoadMonitorConfig(const std::string& path, Diagnostics& diagnostics);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_MONITORING_MONITOR_CONFIG_H_
