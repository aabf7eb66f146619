// Does the robot get onto its station? Judges what the docking action's server says about its
// goals (status and feedback of the action), whoever has given them.
//
// ROS time, but for its silence (silence.h).
#ifndef COPPICE_ROBOT_APP_MONITORING_POWER_DOCKING_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_POWER_DOCKING_MONITOR_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/freshness.h"
#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// The numbers are those of actionlib_msgs/GoalStatus.
enum class GoalPhase : std::uint8_t {
  kPending = 0,
  kActive = 1,
  kPreempted = 2,
  kSucceeded = 3,
  kAborted = 4,
  kRejected = 5,
  kPreempting = 6,
  kRecalling = 7,
  kRecalled = 8,
  kLost = 9,
};

/// One goal, as its server sees it.
struct GoalReport {
  std::string id;
  GoalPhase phase = GoalPhase::kPending;
  std::string message;
};

class DockingMonitor : public Monitor {
 public:
  explicit DockingMonitor(Duration patience = Duration::zero()) : freshness_(patience) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.docking); }
  /// Nothing: docking is not watched, and nothing is reported.
  void Watch(const std::optional<DockingWatch>& watch);

  /// All goals that the server knows; one that it no longer mentions is over.
  void OnGoals(const std::vector<GoalReport>& goals, const Times& now);

  /// Something is done for a goal; so many of its attempts have failed, the last one for `why`.
  void OnProgress(const std::string& id, int failed, const std::string& why, Time now);

  /// "state": is the server heard; names its node. "failures": attempts in a row that did not
  /// succeed, of whichever goals; one that was cancelled, or given up before anything was done for
  /// it (there is no contact to press on), counts neither way. "duration": of the goal that is
  /// under way [s], else 0.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  struct Goal {
    GoalPhase phase = GoalPhase::kPending;
    Time begun{};
    bool is_tried = false;
    int failed = 0;  // attempts
  };
  void End(const GoalReport& report, const Goal& goal, Time now);
  double Longest(Time now) const;

  Freshness freshness_;
  std::optional<DockingWatch> watch_;
  GaugeBoard board_;
  std::map<std::string, Goal> goals_;
  int failures_ = 0;    // in a row
  std::string reason_;  // of the last one
  Time failed_at_{};    // the last one
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_POWER_DOCKING_MONITOR_H_
