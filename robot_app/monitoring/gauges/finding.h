// What a monitor has to say about one thing that it watches.
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_FINDING_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_FINDING_H_

#include <string>

#include "bt_core/base/clock.h"
#include "bt_nodes/monitoring/health.h"

namespace coppice::robot::monitoring {

/// A coppice_msgs/HealthEntry as a plain value.
struct Finding {
  std::string monitor;  ///< kind of monitor: node, topic, navigation, ...
  std::string subject;  ///< what is watched
  std::string node;     ///< ROS node to restart if the level is ERROR or STALE; empty if none
  leaves::HealthLevel level = leaves::HealthLevel::kOk;
  double value = 0;          ///< measured
  std::string unit = {};     ///< of value
  std::string message = {};  ///< for people
  Time stamp{};              ///< of the measurement, ROS time
  std::string host = {};     ///< computer that it is about; empty: the one of the monitor
};

/// Now, on both time lines.
struct Times {
  Time ros{};
  Time wall{};
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_FINDING_H_
