// How often a group was restarted lately, and when it may be restarted again.
//
// The rule is the restart intensity of Erlang/OTP supervisors (MaxR restarts within MaxT), made
// stricter in one point: time alone repairs nothing. A restart is forgotten when it is older than
// the window *and* the group has been healthy for `healthy_after`, so a loop of slow crashes is
// recognised as well as one of fast crashes. What escapes even that is caught by an hourly limit.
#ifndef COPPICE_ROBOT_APP_PROCESSES_RESTART_BUDGET_H_
#define COPPICE_ROBOT_APP_PROCESSES_RESTART_BUDGET_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"
#include "robot_app/processes/config/robot_config.h"

namespace coppice::robot::processes {

/// For people: "2 s", "0.5 s".
std::string SecondsText(Duration duration);

/// Times are handed in and never go back. For one thread.
class RestartBudget {
 public:
  explicit RestartBudget(const RestartLimits& limits) : limits_(limits) {}

  /// Notes whether all of the group is ready now.
  void SetReady(bool ready, Time now);

  /// Ready without a pause for `healthy_after`.
  bool IsHealthy(Time now) const;

  /// Restarts that count against the intensity.
  int Used(Time now);
  int allowed() const { return limits_.restarts; }
  /// Whether one more restart is allowed.
  Outcome Check(Time now);

  void Add(Time now);
  void Clear();

  /// How long to wait before the next restart: none, first, 2 first, 4 first, ... most.
  Duration Delay(const BackOff& back_off, Time now);

  /// All that is to outlive the supervisor: restarts within the last hour, oldest first, and how
  /// many of them (the youngest) count against the intensity.
  const std::vector<Time>& times() const { return times_; }
  std::size_t counting() const { return times_.size() - forgotten_; }
  /// Takes up what another budget has left.
  void Restore(std::vector<Time> times, std::size_t counting);

 private:
  void Prune(Time now);

  RestartLimits limits_;
  std::vector<Time> times_;
  std::size_t forgotten_ = 0;  // the oldest of them count only against the hourly limit
  std::optional<Time> ready_since_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_RESTART_BUDGET_H_
