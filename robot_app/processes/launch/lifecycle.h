// The lives of the processes: launching, ending with a deadline, what phase each is in. Knows
// nothing of dependencies and restarts; what should run is decided by the Supervisor.
#ifndef COPPICE_ROBOT_APP_PROCESSES_LAUNCH_LIFECYCLE_H_
#define COPPICE_ROBOT_APP_PROCESSES_LAUNCH_LIFECYCLE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"
#include "robot_app/common/process_phase.h"
#include "robot_app/processes/config/robot_config.h"
#include "robot_app/processes/launch/process_launcher.h"

namespace coppice::robot::processes {

const char* ToString(ProcessPhase phase);

struct ProcessStatus {
  ProcessPhase phase = ProcessPhase::kStopped;
  int pid = 0;  ///< 0: not running
  std::uint32_t restarts = 0;
  Time since{};           ///< of the last change of phase
  Time back_off_until{};  ///< 0 unless it is backing off
  std::string message;    ///< why, for people; may be empty
};

/// For one thread.
class Lifecycle {
 public:
  /// Both must outlive it.
  Lifecycle(const RobotConfig& config, ProcessLauncher& launcher);

  const ProcessStatus& status(std::size_t process) const { return lives_[process].status; }
  bool IsUp(std::size_t process) const { return lives_[process].status.pid != 0; }
  /// Any but those that are stuck.
  bool AnyUp(Time now) const;
  /// SIGTERM was sent.
  bool IsEnding(std::size_t process) const { return lives_[process].ending; }
  /// SIGKILL was sent a while ago, and still it is there: nobody should wait for it any more.
  bool IsStuck(std::size_t process, Time now) const;
  /// Launched, not ready and not about to end: to be probed for readiness.
  bool AwaitsReadiness(std::size_t process) const;
  /// Awaits readiness for longer than its start timeout.
  bool IsLate(std::size_t process, Time now) const;
  /// Ready, and its heartbeat has been silent for longer than it may.
  bool IsSilent(std::size_t process, Time now) const;
  /// It has told that it was started, or it is on this host.
  bool IsConnected(std::size_t process) const;
  /// Nothing if it was never started.
  std::optional<Time> started_at(std::size_t process) const { return lives_[process].started_at; }

  struct Start {
    bool counts = false;   ///< as a restart
    bool cleared = false;  ///< what it remembers of earlier lives is deleted first
  };
  /// Starts it; it is STARTING then, or remains UNREACHABLE, also after a problem.
  Outcome Launch(std::size_t process, const Start& start, Time now);
  /// SIGTERM, and SIGKILL after the stop timeout.
  void End(std::size_t process, ProcessPhase phase, std::string message, Time now);
  /// Kills what has not ended in time.
  void KillOverdue(Time now);

  void OnHeartbeat(std::size_t process, Time now) { lives_[process].heard_at = now; }
  /// Until now nobody listened: silence counts from here on.
  void ListenFrom(Time now) { listening_since_ = now; }

  struct Ended {
    std::size_t process = 0;
    bool asked = false;      ///< by End
    bool connected = false;  ///< as IsConnected just before
  };
  /// A process of the operating system has ended; nothing if it is none of ours.
  std::optional<Ended> OnExit(int pid);

  void SetPhase(std::size_t process, ProcessPhase phase, std::string message, Time now,
                Time back_off_until = Time{});
  void SetRestarts(std::size_t process, std::uint32_t restarts);

  /// Grows with every change of a status.
  std::uint64_t revision() const { return revision_; }

 private:
  struct Life {
    ProcessStatus status;
    bool ending = false;  // SIGTERM was sent
    bool killed = false;  // SIGKILL was sent
    Time deadline{};      // of the start or of the end
    Time heard_at{};      // its last heartbeat
    std::optional<Time> started_at;
  };

  const RobotConfig& config_;
  ProcessLauncher& launcher_;
  std::vector<Life> lives_;
  Time listening_since_{};
  std::uint64_t revision_ = 0;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_LAUNCH_LIFECYCLE_H_
