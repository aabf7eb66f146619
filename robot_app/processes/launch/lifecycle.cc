#include "robot_app/processes/launch/lifecycle.h"

#include <algorithm>
#include <csignal>
#include <utility>

namespace coppice::robot::processes {

const char* ToString(ProcessPhase phase) {
  switch (phase) {
    case ProcessPhase::kStopped:
      return "STOPPED";
    case ProcessPhase::kStarting:
      return "STARTING";
    case ProcessPhase::kReady:
      return "READY";
    case ProcessPhase::kBackingOff:
      return "BACKING_OFF";
    case ProcessPhase::kGivenUp:
      return "GIVEN_UP";
    case ProcessPhase::kUnreachable:
      return "UNREACHABLE";
  }
  return "?";
}

Lifecycle::Lifecycle(const RobotConfig& config, ProcessLauncher& launcher)
    : config_(config), launcher_(launcher), lives_(config.processes.size()) {}

bool Lifecycle::AnyUp(Time now) const {
  for (std::size_t i = 0; i < lives_.size(); ++i) {
    if (IsUp(i) && !IsStuck(i, now)) return true;
  }
  return false;
}

bool Lifecycle::IsStuck(std::size_t process, Time now) const {
  const Life& life = lives_[process];
  return life.killed && now >= life.deadline + config_.stop_timeout;
}

bool Lifecycle::AwaitsReadiness(std::size_t process) const {
  const Life& life = lives_[process];
  const bool starts = life.status.phase == ProcessPhase::kStarting ||
                      life.status.phase == ProcessPhase::kUnreachable;
  return starts && life.status.pid != 0 && !life.ending;
}

bool Lifecycle::IsLate(std::size_t process, Time now) const {
  return AwaitsReadiness(process) && now >= lives_[process].deadline;
}

bool Lifecycle::IsSilent(std::size_t process, Time now) const {
  const Life& life = lives_[process];
  const auto& heartbeat = config_.processes[process].heartbeat;
  if (!heartbeat || life.status.phase != ProcessPhase::kReady) return false;
  return now - std::max({life.heard_at, life.status.since, listening_since_}) > heartbeat->timeout;
}

bool Lifecycle::IsConnected(std::size_t process) const {
  return !config_.processes[process].host || launcher_.IsConnected(lives_[process].status.pid);
}

Outcome Lifecycle::Launch(std::size_t process, const Start& start, Time now) {
  Life& life = lives_[process];
  const ProcessConfig& config = config_.processes[process];
  life.started_at = now;
  life.deadline = now + config.start_timeout;
  life.status.restarts += start.counts ? 1 : 0;
  if (life.status.phase != ProcessPhase::kUnreachable) {
    SetPhase(process, ProcessPhase::kStarting, "", now);
  }
  if (start.cleared) {
    if (Outcome cleared = launcher_.ClearState(config); !cleared) return cleared;
  }
  const Expected<int> pid = launcher_.Start(config);
  life.status.pid = pid ? *pid : 0;
  return pid ? Outcome() : Problem{pid.problem()};
}

void Lifecycle::End(std::size_t process, ProcessPhase phase, std::string message, Time now) {
  Life& life = lives_[process];
  SetPhase(process, phase, std::move(message), now);
  if (life.ending) return;
  life.ending = true;
  life.deadline = now + config_.stop_timeout;
  launcher_.Signal(life.status.pid, SIGTERM);
}

void Lifecycle::KillOverdue(Time now) {
  for (Life& life : lives_) {
    if (!life.ending || life.killed || now < life.deadline) continue;
    launcher_.Signal(life.status.pid, SIGKILL);
    life.killed = true;
  }
}

std::optional<Lifecycle::Ended> Lifecycle::OnExit(int pid) {
  const auto found = std::find_if(lives_.begin(), lives_.end(),
                                  [pid](const Life& life) { return life.status.pid == pid; });
  if (pid == 0 || found == lives_.end()) return std::nullopt;
  const auto process = static_cast<std::size_t>(found - lives_.begin());
  const Ended ended{process, found->ending, IsConnected(process)};
  found->status.pid = 0;
  found->ending = found->killed = false;
  ++revision_;
  return ended;
}

void Lifecycle::SetPhase(std::size_t process, ProcessPhase phase, std::string message, Time now,
                         Time back_off_until) {
  ProcessStatus& status = lives_[process].status;
  if (status.phase == phase && status.message == message &&
      status.back_off_until == back_off_until) {
    return;
  }
  if (status.phase != phase) status.since = now;
  status.phase = phase;
  status.message = std::move(message);
  status.back_off_until = back_off_until;
  ++revision_;
}

void Lifecycle::SetRestarts(std::size_t process, std::uint32_t restarts) {
  lives_[process].status.restarts = restarts;
}

}  // namespace coppice::robot::processes
