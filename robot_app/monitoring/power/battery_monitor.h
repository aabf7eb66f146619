// Will the robot still reach its charging station? Judges the battery's raw readings, independent
// of the application and of what it makes of them.
//
// ROS time throughout: a simulated battery empties in simulated time.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_BATTERY_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_BATTERY_MONITOR_H_

#include <optional>
#include <vector>

#include "bt_nodes/power/battery_reading.h"
#include "robot_app/monitoring/freshness.h"
#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// What the current says about the charge, and for how long something has not happened.
class CoulombCount {
 public:
  /// Readings further apart than `longest_gap` begin anew.
  explicit CoulombCount(Duration longest_gap) : longest_gap_(longest_gap) {}

  /// The start or end of charging begins anew: then gauges correct themselves. So does a reading
  /// without current or charge.
  void OnReading(const leaves::BatteryReading& reading, double charging_above, Time now);

  double deviation() const { return deviation_; }  ///< Ah, reported less counted
  double unchanged() const { return unchanged_; }  ///< s, the charge stands although current flows
  double since_charge() const { return since_charge_; }  ///< s, since it charged, or was full

 private:
  void Begin(const leaves::BatteryReading& reading, Time now);

  Duration longest_gap_;
  std::optional<leaves::BatteryReading> last_;
  Time last_at_{}, changed_at_{};
  std::optional<Time> charged_at_;  // or the first sample
  double counted_ = 0;              // Ah
  double deviation_ = 0, unchanged_ = 0, since_charge_ = 0;
};

class BatteryMonitor : public Monitor {
 public:
  explicit BatteryMonitor(Duration patience = Duration::zero())
      : freshness_(patience, SilenceIn::kRosTime) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.battery); }
  /// Nothing: the battery is not watched, and nothing is reported.
  void Watch(const std::optional<BatteryLimits>& watch);
  /// A number that has bounds but is not measured counts as one outside them.
  void OnReading(const leaves::BatteryReading& reading, const Times& now);
  /// Length of the way to the station [m]; 0 until it is known.
  void OnDistance(double distance) { distance_ = distance; }

  /// "state": is the battery heard, and has it ever told whether the robot stands on its station;
  /// names the node that publishes it. Then one finding per number.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  void Tell(const char* subject, const Band& band, double value, Time now);
  Finding State(const ProcessTable& processes, const Times& now);

  Freshness freshness_;
  std::optional<BatteryLimits> watch_;
  GaugeBoard board_;
  CoulombCount count_{std::chrono::seconds(10)};
  double distance_ = 0;
  std::optional<Time> since_;   // the first reading
  bool knows_station_ = false;  // it has told whether the robot stands on its station
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_BATTERY_MONITOR_H_
