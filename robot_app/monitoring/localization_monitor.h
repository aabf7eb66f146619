// Does the robot know where it is? Judges what the localization says about itself.
//
// ROS time, but for its silence (silence.h).
#ifndef COPPICE_ROBOT_APP_MONITORING_LOCALIZATION_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_LOCALIZATION_MONITOR_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/freshness.h"
#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// A coppice_msgs/LocalizationState as a plain value.
struct LocalizationReading {
  /// The numbers are those of coppice_msgs/LocalizationState.
  enum class Phase : std::uint8_t { kOk = 0, kUncertain = 1, kLost = 2 };

  Phase phase = Phase::kOk;
  double since_confirmed = 0;  ///< s, age of the last loop closure
  double score = 0;            ///< 0..1
  double deviation = 0;        ///< m
  std::string message;
};

class LocalizationMonitor : public Monitor {
 public:
  explicit LocalizationMonitor(Duration patience = Duration::zero()) : freshness_(patience) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.localization); }
  /// Nothing: localization is not watched, and nothing is reported.
  void Watch(const std::optional<LocalizationWatch>& watch);
  void OnState(LocalizationReading state, const Times& now);

  /// Monitor "localization", naming the localization's node: "phase" (UNCERTAIN is a warning, LOST
  /// an error), "since_confirmed", "score" and "deviation". Monitor "topic": is the state fresh.
  /// An old state says nothing about now.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  Finding Phase(Time now, bool is_fresh) const;

  Freshness freshness_;
  std::optional<LocalizationWatch> watch_;
  std::optional<LocalizationReading> state_;
  GaugeBoard board_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_LOCALIZATION_MONITOR_H_
