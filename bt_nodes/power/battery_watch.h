// Decides from a battery's raw readings alone when the robot must go and charge. It knows nothing
// of the application's own decision, so a mistake there cannot silence it.
//
// The charge is the least of three estimates: what the battery reports, what the voltage says
// (smoothed), and what is left by counting the current. What is not measured is left out; a battery
// that reports neither its level nor its voltage counts as silent. As long as it is silent, or its
// current is not measured, the count goes on at the driving current. A request, once made, stands
// until the battery has been charged, or its charger says that it is full.
//
// Time is that of the caller and never goes back. Not thread-safe.
#ifndef COPPICE_BT_NODES_POWER_BATTERY_WATCH_H_
#define COPPICE_BT_NODES_POWER_BATTERY_WATCH_H_

#include <optional>
#include <string>

#include "bt_nodes/power/battery_estimate.h"
#include "bt_nodes/power/battery_reading.h"

namespace coppice::leaves {

struct BatteryWatchOptions {
  BatteryModel model;
  double longest_without_charge = 4 * 3600;  ///< s
  double longest_silence = 60;               ///< of the battery [s]; then charging is due
  double smoothing = 30;                     ///< time constant for the voltage [s]
  double charged = 0.9;       ///< state of charge at which a charge that counts settles a request
  double counts_after = 600;  ///< so long must current flow to count as a charge [s]
  /// Below this share of the reserve plus the way the robot may not reach the station: critical.
  double critical = 0.5;
  double last_charge = 1.5;  ///< Ah; with no more, or no more than the way takes: exhausted
};

struct BatteryVerdict {
  bool due = false;       ///< the robot must go and charge; latched
  bool critical = false;  ///< and may not make it without help
  /// The last readings say that it will not make it; latched until current flows. Never guessed
  /// from the count alone or while the battery is silent.
  bool exhausted = false;
  double charge = 0;   ///< Ah that are left
  double needed = 0;   ///< Ah for the way to the station and the reserve there
  std::string reason;  ///< why it is due, with numbers, for people; empty if it is not
};

class BatteryWatch {
 public:
  explicit BatteryWatch(BatteryWatchOptions options = {}) : options_(options) {}

  /// Takes in what is known now and decides. `reading`: the newest, or null; one that was seen
  /// before changes nothing. `distance`: of the path to the station [m]; negative: not known, then
  /// the longest that was known so far counts.
  const BatteryVerdict& Update(Time now, const BatteryReading* reading, double distance);

 private:
  void TakeReading(Time now, const BatteryReading& reading);
  void TakeLevels(Time now, const BatteryReading& reading);
  void CountCharge(Time now, double current);
  bool IsExhausted(double way) const;
  double Current(bool is_silent) const;
  std::optional<double> ReadCharge() const;  // from level and voltage
  double LeastCharge() const;
  std::string Reason(Time now) const;

  BatteryWatchOptions options_;
  BatteryVerdict verdict_;
  std::optional<Time> started_;
  Time updated_{};
  Time last_charge_{};        // end of the last one, or the start
  Time heard_{};              // the newest reading of level or voltage
  Time charging_since_{};     // while is_charging_
  bool is_charging_ = false;  // or full, on the charger
  std::optional<BatteryReading> newest_;
  std::optional<double> level_;          // 0..1, as reported
  std::optional<double> voltage_level_;  // 0..1, smoothed
  double counted_ = 0;                   // Ah
  double farthest_ = 0;                  // m
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_POWER_BATTERY_WATCH_H_
