// What a failure leads to: the ladder of escalation of every group.
//
//   group    restart what the group's strategy says, as long as its restart budget lasts
//   closure  restart the root of the trouble and all that depends on it, from a cleared state
//   stack    restart everything, with the ROS master (essential groups only)
//   person   give the group up and ask a person
//
// A group climbs with every failure that it has before it was healthy again, and comes down to the
// first step when it is healthy. When a group that the failing one depends on has failed lately as
// well, that one is the root of the trouble: restarting dependents never helps. However slow the
// failures are, a person is asked within `ask_within` of the first.
//
// A request climbs no further than the closure; then it is refused. A judgement from outside must
// not bring down the whole robot: when a computer has too much to do, all topics are slow, and
// restarts make it worse.
//
// The root rule and the order of the steps: what cured the restart loop of Stuede et al., "Sobi",
// ECMR 2021, by hand. Nested intensities: Erlang/OTP, "Supervisor Behaviour".
#ifndef COPPICE_ROBOT_APP_PROCESSES_ESCALATION_H_
#define COPPICE_ROBOT_APP_PROCESSES_ESCALATION_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/processes/config/group_order.h"
#include "robot_app/processes/restart_budget.h"

namespace coppice::robot::processes {

/// The numbers are those of coppice_msgs/ProcessState.
enum class EscalationStep : std::uint8_t { kGroup = 0, kClosure = 1, kStack = 2, kPerson = 3 };

const char* ToString(EscalationStep step);

/// Why something is restarted.
enum class Cause {
  kEnd,      ///< it ended, or never became ready
  kRequest,  ///< it lives, but somebody who watches it wants it restarted
};

struct Decision {
  bool refused = false;  ///< nothing is to be done
  EscalationStep step = EscalationStep::kGroup;
  std::size_t root = 0;  ///< the group to be restarted or given up
  Duration delay{0};     ///< before the restart
  std::string reason;    ///< why it went beyond the group, for people
};

/// What is remembered of a group across restarts of the supervisor.
struct GroupMemory {
  std::vector<Time> restarts;
  std::size_t counting = 0;
  EscalationStep step = EscalationStep::kGroup;
  int closures = 0;
  std::optional<Time> trouble_since;
  std::string given_up;  ///< the reason; empty unless step is kPerson
};

/// Times are handed in and never go back. For one thread.
class Escalation {
 public:
  /// Both must outlive it.
  Escalation(const RobotConfig& config, const GroupOrder& order);

  /// A process of the group has failed, or is asked to be restarted. Counts it and decides.
  Decision OnFailure(std::size_t group, Cause cause, Time now);

  /// Notes whether all processes of the group that should run are ready. Every round.
  void SetReady(std::size_t group, bool ready, Time now);
  /// The same for all groups together.
  void SetAllReady(bool ready, Time now) { stack_.SetReady(ready, now); }

  /// It waits for another group: the time until then is not held against it.
  void Excuse(std::size_t group, Time now);

  /// In trouble since longer than ask_within. What to do then is to give it up.
  bool IsOverdue(std::size_t group, Time now) const;
  void GiveUp(std::size_t group, std::string reason);

  /// A person has repaired it; what depends on it begins anew as well.
  void Reset(std::size_t group);

  EscalationStep step(std::size_t group) const { return groups_[group].step; }
  bool IsGivenUp(std::size_t group) const { return step(group) == EscalationStep::kPerson; }
  const std::string& given_up(std::size_t group) const { return groups_[group].given_up; }
  bool AnyGivenUp() const;
  int RestartsUsed(std::size_t group, Time now) { return groups_[group].budget.Used(now); }

  GroupMemory Remember(std::size_t group) const;
  void Restore(std::size_t group, const GroupMemory& memory);
  const RestartBudget& stack() const { return stack_; }
  RestartBudget& stack() { return stack_; }

 private:
  struct Group {
    explicit Group(const RestartLimits& limits) : budget(limits) {}
    RestartBudget budget;
    EscalationStep step = EscalationStep::kGroup;
    int closures = 0;                   // restarts of that step since it was healthy
    std::optional<Time> trouble_since;  // the first failure since it was healthy
    std::string given_up;
  };

  std::size_t RootOf(std::size_t group) const;
  Decision Climb(std::size_t group, Cause cause, std::string reason, Time now);

  const RobotConfig& config_;
  const GroupOrder& order_;
  std::vector<Group> groups_;
  RestartBudget stack_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_ESCALATION_H_
