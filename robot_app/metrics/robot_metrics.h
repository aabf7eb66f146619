// How the robot is, in figures: its health, battery, programs, recoveries, requests for help, and
// what waits in its store. Whoever hears of it sets it; a value that was never set is not shown.
#ifndef COPPICE_ROBOT_APP_METRICS_ROBOT_METRICS_H_
#define COPPICE_ROBOT_APP_METRICS_ROBOT_METRICS_H_

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_nodes/monitoring/health.h"
#include "bt_nodes/power/battery_reading.h"
#include "robot_app/metrics/metric_table.h"

namespace coppice::robot::metrics {

struct ProcessFigures {
  std::string name;
  int state = 0;  ///< as in ProcessState.msg
  std::uint32_t restarts = 0;
};

struct ProcessesFigures {
  std::string configuration;
  bool safe_stop = false;
  std::vector<ProcessFigures> processes;
};

/// Any thread. What others call something is told as PlainText, so that Prometheus can read all of
/// the page whatever they say; and of each kind so many at most, so that it takes no more memory
/// than it should.
class RobotMetrics {
 public:
  static constexpr std::size_t kMostOfAKind = 1000;
  static constexpr std::size_t kLongestName = 100;  // bytes

  void SetHealth(const std::vector<leaves::HealthEntry>& entries);
  void SetBattery(const leaves::BatteryReading& battery);
  void SetProcesses(ProcessesFigures processes);
  void SetOpenRequests(std::size_t open);
  /// Figures of the store by their names on /store/status: "documents", "bytes", "lost", ...
  void SetStore(const std::map<std::string, double>& store);
  /// A recovery has come to that phase: "begun", "helped", ...
  void CountRecovery(const std::string& recovery, const std::string& phase);

  void Collect(MetricTable& table) const;

 private:
  void CollectHealth(MetricTable& table) const;
  void CollectBattery(MetricTable& table) const;
  void CollectProcesses(MetricTable& table) const;
  void CollectStore(MetricTable& table) const;

  mutable std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, leaves::HealthLevel> worst_;  // by monitor, subject
  std::optional<leaves::BatteryReading> battery_;
  std::optional<ProcessesFigures> processes_;
  std::optional<std::size_t> open_requests_;
  std::map<std::string, double> store_;
  std::map<std::pair<std::string, std::string>, std::uint64_t> recoveries_;
};

}  // namespace coppice::robot::metrics

#endif  // COPPICE_ROBOT_APP_METRICS_ROBOT_METRICS_H_
