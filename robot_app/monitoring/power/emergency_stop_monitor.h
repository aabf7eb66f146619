// Is the emergency stop pressed? Then the motors have no power, and only a person can release it.
// ROS time throughout.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_EMERGENCY_STOP_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_EMERGENCY_STOP_MONITOR_H_

#include <optional>
#include <vector>

#include "robot_app/monitoring/gauges/finding.h"
#include "robot_app/monitoring/gauges/patience.h"
#include "robot_app/monitoring/power/power_watch.h"

namespace coppice::robot {

class EmergencyStopMonitor {
 public:
  explicit EmergencyStopMonitor(Duration patience = Duration::zero()) : patience_(patience) {}

  /// Nothing: it is not watched, and nothing is reported.
  void Watch(const std::optional<EmergencyStopWatch>& watch);
  void OnState(bool is_pressed, Time now);

  /// One finding, subject "button"; an error while it is pressed, at once. Value: for how long [s].
  std::vector<Finding> Report(const Times& now);

 private:
  Duration patience_;
  Patience freshness_;
  std::optional<EmergencyStopWatch> watch_;
  std::optional<Time> pressed_at_;
  std::optional<Time> heard_at_;  // the last message, or the first report
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_EMERGENCY_STOP_MONITOR_H_
