// Will the robot still reach its charging station? Judges the battery's raw readings, independent
// of the application and of what it makes of them.
//
// ROS time throughout: a simulated battery empties in simulated time.
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_BATTERY_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_BATTERY_MONITOR_H_

#include <optional>
#include <vector>

#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/gauges/patience.h"
#include "robot_app/monitoring/power/power_watch.h"
#include "robot_app/monitoring/process_table.h"

namespace coppice::robot {

/// A sensor_msgs/BatteryState as a plain value. NaN: not measured.
struct BatterySample {
  double voltage = 0;       ///< V
  double current = 0;       ///< A, positive: into the battery
  double charge = 0;        ///< Ah
  double level = 0;         ///< state of charge, 0..1
  bool on_charger = false;  ///< the contacts touch, whether or not current flows
  bool is_full = false;     ///< the charger says so
};

/// What the current says about the charge, and for how long something has not happened.
class CoulombCount {
 public:
  /// Readings further apart than `longest_gap` begin anew.
  explicit CoulombCount(Duration longest_gap) : longest_gap_(longest_gap) {}

  /// The start or end of charging begins anew: then gauges correct themselves.
  void OnSample(const BatterySample& sample, double charging_above, Time now);

  double deviation() const { return deviation_; }  ///< Ah, reported less counted
  double unchanged() const { return unchanged_; }  ///< s, the charge stands although current flows
  double since_charge() const { return since_charge_; }  ///< s, since the last charging current

 private:
  void Begin(const BatterySample& sample, Time now);

  Duration longest_gap_;
  std::optional<BatterySample> last_;
  Time last_at_{0}, changed_at_{0};
  std::optional<Time> charged_at_;  // or the first sample
  double counted_ = 0;              // Ah
  double deviation_ = 0, unchanged_ = 0, since_charge_ = 0;
};

class BatteryMonitor {
 public:
  explicit BatteryMonitor(Duration patience = Duration::zero()) : patience_(patience) {}

  /// Nothing: the battery is not watched, and nothing is reported.
  void Watch(const std::optional<BatteryWatch>& watch);
  void OnSample(const BatterySample& sample, Time now);
  /// Length of the way to the station [m]; 0 until it is known.
  void OnDistance(double distance) { distance_ = distance; }

  /// "state": is the battery heard; names the node that publishes it. Then one finding per number.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now);

 private:
  Finding State(Time now) const;

  Duration patience_;
  Patience freshness_;
  std::optional<BatteryWatch> watch_;
  GaugeBoard board_;
  CoulombCount count_{std::chrono::seconds(10)};
  double distance_ = 0;
  std::optional<Time> heard_at_;  // the last sample, or the first report
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_BATTERY_MONITOR_H_
