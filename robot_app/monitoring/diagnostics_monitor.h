// What other programs say about themselves on /diagnostics, as entries of the robot's health
// (http://wiki.ros.org/diagnostics, REP 107). What Coppice itself says there is not read back.
//
// All times are wall time: programs repeat their diagnostics in it.
#ifndef COPPICE_ROBOT_APP_MONITORING_DIAGNOSTICS_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_DIAGNOSTICS_MONITOR_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// Names of diagnostics that begin so are Coppice's own.
inline constexpr char kOwnDiagnostics[] = "coppice: ";

class DiagnosticsMonitor : public Monitor {
 public:
  void Watch(const WatchList& list, const Times& now) override {
    Watch(list.diagnostics, now.wall);
  }
  /// Nothing: nothing is read. A change forgets who has fallen silent, or is not heard any more
  /// from then on: the programs of the configuration may be others.
  void Watch(const std::optional<DiagnosticsWatch>& watch, Time now);

  /// `level`: that of diagnostic_msgs/DiagnosticStatus; a number that is not known is the worst.
  void OnStatus(const std::string& name, int level, const std::string& message, Time now);

  /// One finding per name; STALE from the staleness on until it is heard again. Of 2000 names, and
  /// of 1000 bytes of a message; for a minute it is told that there were more.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  struct Status {
    std::string name;
    leaves::HealthLevel level = leaves::HealthLevel::kOk;
    std::string message;
    Time heard_at{};
    bool was_heard_since_change = true;  // of what is watched
  };
  Status* Of(const std::string& name, Time now);

  std::optional<DiagnosticsWatch> watch_;
  std::vector<Status> statuses_;
  std::optional<Time> refused_at_;  // more names than there is room for
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_DIAGNOSTICS_MONITOR_H_
