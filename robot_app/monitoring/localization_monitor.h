// Does the robot know where it is? Judges what the localization says about itself.
//
// ROS time, but for its silence (silence.h).
#ifndef COPPICE_ROBOT_APP_MONITORING_LOCALIZATION_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_LOCALIZATION_MONITOR_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/gauges/patience.h"
#include "robot_app/monitoring/gauges/silence.h"
#include "robot_app/monitoring/gauges/watch.h"
#include "robot_app/monitoring/process_table.h"

namespace coppice::robot {

/// The numbers are those of coppice_msgs/LocalizationState.
enum class LocalizationPhase : std::uint8_t { kOk = 0, kUncertain = 1, kLost = 2 };

/// A coppice_msgs/LocalizationState as a plain value.
struct LocalizationReport {
  LocalizationPhase phase = LocalizationPhase::kOk;
  double since_confirmed = 0;  ///< s, age of the last loop closure
  double score = 0;            ///< 0..1
  double deviation = 0;        ///< m
  std::string message;
};

class LocalizationMonitor {
 public:
  explicit LocalizationMonitor(Duration patience = Duration::zero()) : patience_(patience) {}

  /// Nothing: localization is not watched, and nothing is reported.
  void Watch(const std::optional<LocalizationWatch>& watch);
  void OnState(LocalizationReport state, const Times& now);

  /// Monitor "localization", naming the localization's node: "phase" (UNCERTAIN is a warning, LOST
  /// an error), "since_confirmed", "score" and "deviation". Monitor "topic": is the state fresh.
  /// An old state says nothing about now.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now);

 private:
  Finding Phase(Time now, bool is_fresh) const;
  Finding Freshness(Time now, Duration silence) const;

  Duration patience_;
  Patience freshness_;
  std::optional<LocalizationWatch> watch_;
  std::optional<LocalizationReport> state_;
  GaugeBoard board_;
  Silence silence_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_MONITORING_LOCALIZATION_MONITOR_H_
