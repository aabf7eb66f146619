// The core of the process supervisor: which process runs when. It is the only one that starts and
// ends the robot's programs; two restart mechanisms that do not know each other fight. Time and the
// means to start a process are handed in.
//
// One rule says who restarts: a process that *ends*, or whose heartbeat falls silent, is restarted
// here and at once; one that lives but is ill (hung, silent) is restarted on the request of who
// found that out, the monitor tree or a person. All count against the same budget, and what exceeds
// it climbs the ladder of Escalation.
//
// What should run is desired state, worked out anew in every step: the processes of the
// configuration, without groups that were given up and what depends on those. What should not run
// ends, dependents before what they depend on; then what is missing starts, dependencies first. A
// restart of several processes is a wave: all of them end before the first starts again.
//
// Processes live in the computer's time, not in ROS time: a program takes just as long to load when
// simulated time runs eight times as fast. All times here are of a wall clock.
#ifndef COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_H_
#define COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/processes/config/configuration_switch.h"
#include "robot_app/processes/config/group_order.h"
#include "robot_app/processes/escalation.h"
#include "robot_app/processes/launch/lifecycle.h"
#include "robot_app/processes/supervisor_memory.h"

namespace coppice::robot::processes {

/// Whether a site may be entered, or why not.
using CheckSite = std::function<Outcome(const std::string& site)>;

/// For one thread.
class Supervisor {
 public:
  /// Nothing is started before the first Step. The launcher must outlive the supervisor. `memory`:
  /// what an earlier supervisor of the same robot has left.
  Supervisor(RobotConfig config, ProcessLauncher& launcher, const SupervisorMemory& memory = {});
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// Asks for a configuration; see ConfigurationSwitch.
  Expected<std::string> SetConfiguration(const std::string& name, Hand hand,
                                         const CheckCondition& check);
  /// Ends what a person has set by hand.
  std::string Release();
  /// The robot was brought to another site: everything ends, and begins anew with what belongs to
  /// that one, in its configuration. All that says so is the memory's `site`: whoever saves it has
  /// changed the site, before the first program ends. Refused in a safe stop, to the trees while a
  /// person holds the configuration, and if `check`, which is asked last, says that the site is not
  /// complete or cannot be saved.
  Expected<std::string> SetSite(const std::string& name, Hand hand, const CheckSite& check);
  /// To the configuration for the safe stop, until Reset. Refused if there is none.
  Expected<std::string> SafeStop();

  /// Ends a process (SIGTERM, after stop_timeout SIGKILL to its group) and starts it again, with
  /// those that the strategy of its group says; what depends on it stays up. `name` is a process, a
  /// ROS node or a group; "all" is the whole stack with the ROS master. Counts like a crash, so it
  /// may lead to a restart of all that depends on it. Ok when this has begun, also if it was under
  /// way already. Refused when the name is unknown, not part of the configuration or given up, and
  /// when all these restarts have not helped. `cleared`: what was asked for starts from a cleared
  /// state; of the whole stack, everything.
  Expected<std::string> Restart(const std::string& name, Time now, bool cleared = false);

  /// A person has repaired something: forgets the restarts of its group, and starts it if it was
  /// given up. `name` is a process, a ROS node, a group or "all".
  Expected<std::string> Reset(const std::string& name, Time now);

  /// A process of the operating system has ended. `wait_status` is that of waitpid. Unknown pids
  /// are ignored.
  void OnExit(int pid, int wait_status, Time now);

  /// A started process has become ready. Ignored if it is not STARTING with this pid.
  void OnReady(std::size_t process, int pid, Time now);

  /// A process has shown that it works. Only those with a heartbeat in their configuration must.
  void OnHeartbeat(std::size_t process, Time now) { lifecycle_.OnHeartbeat(process, now); }

  /// The ROS master has ended, or our place in its graph is lost: everything has to begin anew.
  /// `what`: for people.
  void OnMasterEnded(Time now, const std::string& what = "the ROS master ended");

  /// Does what is due: starts, ends, kills. To be called every few tens of milliseconds.
  void Step(Time now);

  /// From now on everything ends, in reverse order of dependency.
  void StopAll() { stopping_ = true; }
  bool stopping() const { return stopping_; }
  /// Nothing runs any more, except what cannot even be killed.
  bool AllStopped(Time now) const { return !lifecycle_.AnyUp(now); }

  /// The whole stack is to be restarted, and everything has ended. The owner restarts the ROS
  /// master and makes a new supervisor with the memory of this one.
  bool NeedsNewStack(Time now) const { return new_stack_ && AllStopped(now); }

  /// Why the whole stack is restarted.
  const std::string& stack_reason() const { return stack_reason_; }

  /// Messages for a person since the last call: what was given up and why.
  std::vector<std::string> TakeCalls();

  /// What a supervisor after this one has to know.
  SupervisorMemory Remember() const { return RememberAt(site_); }
  /// The same once the robot is at that site.
  SupervisorMemory RememberAt(const std::string& site) const;

  const RobotConfig& config() const { return config_; }
  const ConfigurationSwitch& configuration_switch() const { return switch_; }
  const std::string& configuration() const {
    return config_.configurations[switch_.current()].name;
  }
  /// Where the robot is, or is about to be; empty if the file has no table of sites.
  const std::string& site() const { return site_; }
  /// Not all processes of the configuration are ready, or others still run.
  bool IsChanging() const;
  const ProcessStatus& status(std::size_t process) const { return lifecycle_.status(process); }
  EscalationStep escalation(std::size_t process) const;
  int RestartsUsed(std::size_t process, Time now);
  bool AwaitsReadiness(std::size_t process) const { return lifecycle_.AwaitsReadiness(process); }
  /// Grows with every change of a status or of the configuration.
  std::uint64_t revision() const { return revision_ + lifecycle_.revision(); }

 private:
  struct Plan {
    bool end_first = false;   // it runs and has to end before it may start again
    bool as_restart = false;  // the next start is one that counts
    bool done = false;        // ended by itself, and is not to be started again
    std::uint32_t wave = 0;   // those of a wave end before the first of them starts
    bool cleared = false;     // starts from cleared state
    Time not_before{};
    std::string reason;
  };

  struct Restarting {
    std::string reason;
    Time not_before{};
    bool cleared = false;
  };

  std::optional<std::size_t> Find(const std::string& name) const;
  std::optional<std::size_t> FindGroup(const std::string& name) const;
  Problem Unknown(const std::string& name) const;
  Expected<std::string> RestartWanted(std::size_t process, const Indices& members,
                                      const std::string& name, Time now, bool cleared);

  bool IsWanted(std::size_t process) const;
  /// A group that it cannot do without was given up, maybe its own.
  std::optional<std::size_t> GivenUpAbove(std::size_t process) const;
  bool MustEnd(std::size_t process) const;
  bool DependentsEnd(std::size_t process, Time now) const;
  bool IsSatisfied(std::size_t process) const;
  std::optional<std::size_t> MissingNeed(std::size_t process) const;
  std::optional<std::size_t> MissingDependency(std::size_t process) const;
  bool IsEndingFirst(std::size_t process, Time now) const;

  void NoticeOwnPause(Time now);
  void StepHealth(Time now);
  void StepUp(std::size_t process, Time now);
  void StepDown(std::size_t process, Time now);
  void EndNow(std::size_t process, Time now);
  void Launch(std::size_t process, Time now);

  Decision Fail(std::size_t process, Cause cause, const std::string& reason, Time now);
  void LoseHost(std::size_t process, Time now);
  void BeginWave(const Indices& processes, const Restarting& how, Time now);
  void RestartStack(const std::string& reason, bool cleared);
  void GiveUp(std::size_t group, const std::string& reason);

  const RobotConfig config_;
  const GroupOrder order_;
  Lifecycle lifecycle_;
  Escalation escalation_;
  ConfigurationSwitch switch_;
  std::vector<Plan> plans_;
  std::vector<std::string> calls_;
  std::uint32_t last_wave_ = 0;
  Time last_step_{};
  bool stopping_ = false;
  bool new_stack_ = false;
  bool clear_stack_ = false;
  std::string stack_reason_;
  std::string site_;
  std::uint64_t revision_ = 0;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_SUPERVISOR_H_
