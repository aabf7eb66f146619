// What is watched in one configuration of the robot, as plain values.
#ifndef COPPICE_ROBOT_APP_MONITORING_WATCH_LIST_H_
#define COPPICE_ROBOT_APP_MONITORING_WATCH_LIST_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/watch.h"
#include "robot_app/monitoring/power/power_watch.h"

namespace coppice::robot::monitoring {

struct WatchList {
  std::string configuration;
  std::vector<NodeWatch> nodes;
  std::vector<TopicWatch> topics;
  std::vector<PublisherWatch> publishers;
  std::optional<NavigationWatch> navigation;
  std::optional<LocalizationWatch> localization;
  std::vector<TransformWatch> transforms;
  std::vector<LoggerWatch> loggers;
  std::optional<DiagnosticsWatch> diagnostics;
  std::optional<BatteryLimits> battery;
  std::optional<ChargingWatch> charging;  ///< judged by the battery's messages
  std::optional<DockingWatch> docking;
  std::optional<EmergencyStopWatch> emergency_stop;
  std::vector<SourceWatch> sources;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_WATCH_LIST_H_
