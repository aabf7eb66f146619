// Does the battery really charge? Contact alone is no success: on the station current must flow
// soon, and go on flowing until the battery is full.
//
// ROS time throughout.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_CHARGING_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_CHARGING_MONITOR_H_

#include <optional>
#include <vector>

#include "bt_nodes/power/battery_reading.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

class ChargingMonitor : public Monitor {
 public:
  void Watch(const WatchList& list, const Times&) override { Watch(list.charging); }
  /// Nothing: charging is not watched, and nothing is reported.
  void Watch(const std::optional<ChargingWatch>& watch) { watch_ = watch; }
  void OnReading(const leaves::BatteryReading& reading, Time now);

  /// One finding, "current"; value: A. Off the station, and with a full battery, all is well.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  std::optional<ChargingWatch> watch_;
  std::optional<leaves::BatteryReading> reading_;  // the last one
  Time heard_at_{};
  std::optional<Time> missing_since_;  // current, although there is contact
  bool has_flowed_ = false;            // since the contact
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_CHARGING_MONITOR_H_
