// Is the emergency stop pressed? Then the motors have no power, and only a person can release it.
// ROS time throughout.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_EMERGENCY_STOP_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_EMERGENCY_STOP_MONITOR_H_

#include <optional>
#include <vector>

#include "robot_app/monitoring/freshness.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

class EmergencyStopMonitor : public Monitor {
 public:
  explicit EmergencyStopMonitor(Duration patience = Duration::zero())
      : freshness_(patience, SilenceIn::kRosTime) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.emergency_stop); }
  /// Nothing: it is not watched, and nothing is reported.
  void Watch(const std::optional<EmergencyStopWatch>& watch);
  void OnState(bool is_pressed, const Times& now);

  /// One finding, subject "button"; an error while it is pressed, at once. Value: for how long [s].
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  Freshness freshness_;
  std::optional<EmergencyStopWatch> watch_;
  std::optional<Time> pressed_at_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_EMERGENCY_STOP_MONITOR_H_
