// The core of the process supervisor: which process runs when, as a plain state machine. It is the
// only one that starts and ends the robot's programs; two restart mechanisms that do not know each
// other fight. Time and the means to start a process are handed in.
//
// Processes live in the computer's time, not in ROS time: a program takes just as long to load when
// simulated time runs eight times as fast. All times here are of a wall clock.
//
//             Step            OnReady
//   STOPPED --------> STARTING -------> READY
//      ^                | ^ |             |
//      | start timeout  | | | Restart     | Restart: end, then STARTING
//      +----------------+ | +-------------+
//      | OnExit, rule by_tree             | OnExit, other rules
//      +----------------------------------+--> BACKING_OFF --> STARTING
//   restarted too often: GIVEN_UP, left only by Reset
#ifndef COPPICE_ROBOT_APP_SUPERVISION_SUPERVISOR_H_
#define COPPICE_ROBOT_APP_SUPERVISION_SUPERVISOR_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/supervision/process_launcher.h"
#include "robot_app/supervision/robot_config.h"

namespace coppice::robot {

/// The numbers are those of coppice_msgs/ProcessState.
enum class ProcessPhase : std::uint8_t {
  kStopped = 0,
  kStarting = 1,  ///< waits for its dependencies, is started but not ready, or ends for a restart
  kReady = 2,
  kBackingOff = 3,
  kGivenUp = 4,
};

const char* ToString(ProcessPhase phase);

struct ProcessStatus {
  ProcessPhase phase = ProcessPhase::kStopped;
  int pid = 0;  ///< 0: not running
  std::uint32_t restarts = 0;
  Time since{0};        ///< of the last change of phase
  std::string message;  ///< why, for people; may be empty
};

/// The answer to a request.
struct Verdict {
  bool ok = false;
  std::string message;
};

/// For one thread.
class Supervisor {
 public:
  /// Nothing is started before the first Step. The launcher must outlive the supervisor.
  Supervisor(RobotConfig config, ProcessLauncher& launcher);

  /// Brings the set of running processes to a configuration: first what is not needed ends,
  /// dependents before what they depend on, then what is missing starts, dependencies first.
  Verdict SetConfiguration(const std::string& name);

  /// Ends a process (SIGTERM, after stop_timeout SIGKILL to its group) and starts it again; what
  /// depends on it stays up. `name` is a process or a ROS node. Ok when this has begun, also if it
  /// was under way already. Refused when the process is unknown, not part of the configuration,
  /// given up, or would exceed the restart intensity; then it is ended and given up.
  Verdict Restart(const std::string& name, Time now);

  /// A person has repaired a process: forgets its restarts and starts it if it does not run.
  Verdict Reset(const std::string& name, Time now);

  /// A process has ended. `wait_status` is that of waitpid. Unknown pids are ignored.
  void OnExit(int pid, int wait_status, Time now);

  /// A started process has become ready. Ignored if it is not STARTING with this pid.
  void OnReady(std::size_t process, int pid, Time now);

  /// Does what is due: starts, ends, kills. To be called every few tens of milliseconds.
  void Step(Time now);

  /// From now on everything ends, in reverse order of dependency.
  void StopAll() { stopping_ = true; }
  bool AllStopped() const;

  const RobotConfig& config() const { return config_; }
  const std::string& configuration() const { return config_.configurations[configuration_].name; }
  const ProcessStatus& status(std::size_t process) const { return states_[process].status; }
  /// STARTING, launched, and not about to be ended: to be probed for readiness.
  bool AwaitsReadiness(std::size_t process) const;
  /// Grows with every change of a status or of the configuration.
  std::uint64_t revision() const { return revision_; }

 private:
  enum class AfterEnd : std::uint8_t { kStop, kStartAgain, kCountAsFailure };

  struct State {
    ProcessStatus status;
    bool failed = false;  // ended by itself: not started again without a request
    bool ending = false;  // SIGTERM was sent
    bool killed = false;  // SIGKILL was sent
    AfterEnd after_end = AfterEnd::kStop;
    Time deadline{0};            // of the start, of the end, or of the back-off
    std::vector<Time> restarts;  // within the window
  };

  std::optional<std::size_t> Find(const std::string& name) const;
  Verdict Unknown(const std::string& name) const;
  bool Wanted(std::size_t process) const;
  bool DependentsEnd(std::size_t process) const;  // something that waited for it is ending
  bool UnwantedRun() const;
  /// The first that it has to wait for; nothing if it may start.
  std::optional<std::size_t> MissingDependency(std::size_t process) const;

  void StepRunning(std::size_t process, Time now);
  void StepStopped(std::size_t process, Time now);
  void Launch(std::size_t process, Time now);
  void End(std::size_t process, AfterEnd after, std::string message, Time now);
  void Failed(std::size_t process, bool may_restart, std::string message, Time now);
  void GiveUp(std::size_t process, Time now);
  bool RestartsAreUsedUp(State& state, Time now) const;
  void SetPhase(std::size_t process, ProcessPhase phase, std::string message, Time now);

  RobotConfig config_;
  ProcessLauncher& launcher_;
  std::vector<State> states_;
  std::size_t configuration_;
  bool stopping_ = false;
  std::uint64_t revision_ = 0;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_SUPERVISION_SUPERVISOR_H_
