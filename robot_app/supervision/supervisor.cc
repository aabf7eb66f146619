#include "robot_app/supervision/supervisor.h"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <utility>

namespace coppice::robot {
namespace {

std::string InSeconds(Duration duration) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(duration).count();
  std::string text = std::to_string(ms / 1000);
  if (ms % 1000 != 0) text += "." + std::to_string(ms % 1000 / 100);
  return text + " s";
}

std::string DescribeEnd(int wait_status) {
  if (WIFSIGNALED(wait_status)) {
    return "ended by signal " + std::to_string(WTERMSIG(wait_status));
  }
  return "ended with exit status " + std::to_string(WEXITSTATUS(wait_status));
}

bool Contains(const std::vector<std::size_t>& list, std::size_t wanted) {
  return std::find(list.begin(), list.end(), wanted) != list.end();
}

bool EndedWell(int wait_status) { return WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0; }

}  // namespace

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
  }
  return "?";
}

Supervisor::Supervisor(RobotConfig config, ProcessLauncher& launcher)
    : config_(std::move(config)),
      launcher_(launcher),
      states_(config_.processes.size()),
      configuration_(config_.initial) {}

std::optional<std::size_t> Supervisor::Find(const std::string& name) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const ProcessConfig& process = config_.processes[i];
    if (process.name == name || (!name.empty() && process.node == name)) return i;
  }
  return std::nullopt;
}

Verdict Supervisor::Unknown(const std::string& name) const {
  std::vector<std::string> names;
  for (const ProcessConfig& process : config_.processes) {
    names.push_back(process.name);
    if (!process.node.empty()) names.push_back(process.node);
  }
  return {false, "no process or node \"" + name + "\" " + DidYouMean(name, names)};
}

bool Supervisor::Wanted(std::size_t process) const {
  return !stopping_ && Contains(config_.configurations[configuration_].processes, process);
}

bool Supervisor::AwaitsReadiness(std::size_t process) const {
  const State& state = states_[process];
  return state.status.phase == ProcessPhase::kStarting && state.status.pid != 0 && !state.ending;
}

bool Supervisor::AllStopped() const {
  return std::all_of(states_.begin(), states_.end(),
                     [](const State& state) { return state.status.pid == 0; });
}

// Those that stay up must do without it, or they would depend on it.
bool Supervisor::DependentsEnd(std::size_t process) const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].status.pid == 0 || Wanted(i)) continue;
    const ProcessConfig& other = config_.processes[i];
    if (Contains(other.depends, process) || Contains(other.after, process)) return true;
  }
  return false;
}

bool Supervisor::UnwantedRun() const {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].status.pid != 0 && !Wanted(i)) return true;
  }
  return false;
}

std::optional<std::size_t> Supervisor::MissingDependency(std::size_t process) const {
  for (const std::size_t needed : config_.processes[process].depends) {
    if (states_[needed].status.phase != ProcessPhase::kReady) return needed;
  }
  for (const std::size_t earlier : config_.processes[process].after) {
    const State& state = states_[earlier];
    const bool will_be_ready = state.status.phase == ProcessPhase::kStarting ||
                               (state.status.phase == ProcessPhase::kStopped && !state.failed);
    if (Wanted(earlier) && will_be_ready) return earlier;
  }
  return std::nullopt;
}

Verdict Supervisor::SetConfiguration(const std::string& name) {
  if (stopping_) return {false, "the supervisor is stopping"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < config_.configurations.size(); ++i) {
    names.push_back(config_.configurations[i].name);
    if (names.back() != name) continue;
    if (i == configuration_) return {true, "configuration " + name + " is already in force"};
    for (const std::size_t process : config_.configurations[i].processes) {
      if (!Wanted(process)) states_[process].failed = false;
    }
    configuration_ = i;
    ++revision_;
    return {true, "changing to configuration " + name};
  }
  return {false, "no configuration \"" + name + "\" " + DidYouMean(name, names)};
}

Verdict Supervisor::Restart(const std::string& name, Time now) {
  const auto process = Find(name);
  if (!process) return Unknown(name);
  State& state = states_[*process];
  const std::string& full_name = config_.processes[*process].name;
  if (stopping_) return {false, "the supervisor is stopping"};
  if (!Wanted(*process)) {
    return {false, full_name + " is not part of configuration " + configuration()};
  }
  if (state.status.phase == ProcessPhase::kGivenUp) {
    return {false, full_name + " is given up: " + state.status.message};
  }
  if (state.status.phase == ProcessPhase::kStarting && !AwaitsReadiness(*process)) {
    return {true, full_name + " is about to start already"};
  }
  if (RestartsAreUsedUp(state, now)) {
    GiveUp(*process, now);
    return {false, full_name + " is given up: " + state.status.message};
  }
  state.restarts.push_back(now);
  ++state.status.restarts;
  state.failed = false;
  if (state.status.pid != 0) {
    End(*process, AfterEnd::kStartAgain, "ends before it is started again", now);
  } else {
    SetPhase(*process, ProcessPhase::kStarting, "", now);
  }
  return {true, full_name + " is restarted"};
}

Verdict Supervisor::Reset(const std::string& name, Time now) {
  const auto process = Find(name);
  if (!process) return Unknown(name);
  State& state = states_[*process];
  state.restarts.clear();
  state.failed = false;
  if (state.status.phase == ProcessPhase::kGivenUp ||
      state.status.phase == ProcessPhase::kBackingOff) {
    SetPhase(*process, ProcessPhase::kStopped, "reset", now);
  }
  return {true, "restarts of " + config_.processes[*process].name + " are forgotten"};
}

void Supervisor::OnExit(int pid, int wait_status, Time now) {
  const auto found = std::find_if(states_.begin(), states_.end(),
                                  [pid](const State& state) { return state.status.pid == pid; });
  if (pid == 0 || found == states_.end()) return;
  const std::size_t process = static_cast<std::size_t>(found - states_.begin());
  const bool asked = found->ending;
  found->status.pid = 0;
  found->ending = found->killed = false;
  ++revision_;
  if (!asked) {
    const RestartRule rule = config_.processes[process].restart;
    const bool again = rule == RestartRule::kAlways ||
                       (rule == RestartRule::kOnFailure && !EndedWell(wait_status));
    Failed(process, again, DescribeEnd(wait_status), now);
  } else if (found->after_end == AfterEnd::kCountAsFailure) {
    Failed(process, config_.processes[process].restart != RestartRule::kByTree,
           found->status.message, now);
  } else if (found->after_end == AfterEnd::kStop && found->status.phase != ProcessPhase::kGivenUp) {
    SetPhase(process, ProcessPhase::kStopped, "", now);
  }
}

void Supervisor::OnReady(std::size_t process, int pid, Time now) {
  if (!AwaitsReadiness(process) || states_[process].status.pid != pid) return;
  SetPhase(process, ProcessPhase::kReady, "", now);
}

void Supervisor::Step(Time now) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].status.pid != 0) {
      StepRunning(i, now);
    } else {
      StepStopped(i, now);
    }
  }
}

void Supervisor::StepRunning(std::size_t process, Time now) {
  State& state = states_[process];
  if (state.ending) {
    if (!state.killed && now >= state.deadline) {
      launcher_.Signal(state.status.pid, SIGKILL);
      state.killed = true;
    }
  } else if (!Wanted(process)) {
    if (!DependentsEnd(process)) End(process, AfterEnd::kStop, "is ended", now);
  } else if (state.status.phase == ProcessPhase::kStarting && now >= state.deadline) {
    End(process, AfterEnd::kCountAsFailure,
        "was not ready within " + InSeconds(config_.processes[process].start_timeout), now);
  }
}

void Supervisor::StepStopped(std::size_t process, Time now) {
  State& state = states_[process];
  if (!Wanted(process)) {
    if (state.status.phase != ProcessPhase::kStopped &&
        state.status.phase != ProcessPhase::kGivenUp) {
      SetPhase(process, ProcessPhase::kStopped, "", now);
    }
    return;
  }
  if (state.status.phase == ProcessPhase::kGivenUp || state.failed) return;
  if (state.status.phase == ProcessPhase::kBackingOff) {
    if (now < state.deadline) return;
    state.restarts.push_back(now);
    ++state.status.restarts;
  }
  if (UnwantedRun()) return;  // first what ends, then what starts
  if (const auto needed = MissingDependency(process)) {
    SetPhase(process, ProcessPhase::kStarting, "waits for " + config_.processes[*needed].name, now);
    return;
  }
  Launch(process, now);
}

void Supervisor::Launch(std::size_t process, Time now) {
  State& state = states_[process];
  const ProcessConfig& config = config_.processes[process];
  std::string error;
  state.status.pid = launcher_.Start(config, error);
  if (state.status.pid == 0) {
    Failed(process, config.restart != RestartRule::kByTree, error, now);
    return;
  }
  state.deadline = now + config.start_timeout;
  SetPhase(process, ProcessPhase::kStarting, "", now);
  if (config.ready == Readiness::kNone) SetPhase(process, ProcessPhase::kReady, "", now);
}

// The phase is set first, so that the one that reads it knows why the process goes.
void Supervisor::End(std::size_t process, AfterEnd after, std::string message, Time now) {
  State& state = states_[process];
  const ProcessPhase phase =
      after == AfterEnd::kStartAgain ? ProcessPhase::kStarting : ProcessPhase::kStopped;
  SetPhase(process, phase, std::move(message), now);
  state.after_end = after;
  if (state.ending) return;
  state.ending = true;
  state.deadline = now + config_.stop_timeout;
  launcher_.Signal(state.status.pid, SIGTERM);
}

void Supervisor::Failed(std::size_t process, bool may_restart, std::string message, Time now) {
  State& state = states_[process];
  if (!may_restart) {
    state.failed = true;
    SetPhase(process, ProcessPhase::kStopped, std::move(message), now);
    return;
  }
  if (RestartsAreUsedUp(state, now)) {
    GiveUp(process, now);
    return;
  }
  Duration delay = Duration::zero();
  for (std::size_t i = 0; i < state.restarts.size(); ++i) {
    delay = i == 0 ? config_.back_off.first : std::min(2 * delay, config_.back_off.most);
  }
  state.deadline = now + delay;
  SetPhase(process, ProcessPhase::kBackingOff, message + "; starts again after " + InSeconds(delay),
           now);
}

void Supervisor::GiveUp(std::size_t process, Time now) {
  State& state = states_[process];
  const std::string reason = "restarted " + std::to_string(state.restarts.size()) +
                             " times within " + InSeconds(config_.intensity.window);
  if (state.status.pid != 0) End(process, AfterEnd::kStop, reason, now);
  SetPhase(process, ProcessPhase::kGivenUp, reason, now);
}

bool Supervisor::RestartsAreUsedUp(State& state, Time now) const {
  const Time oldest = now - config_.intensity.window;
  state.restarts.erase(std::remove_if(state.restarts.begin(), state.restarts.end(),
                                      [oldest](Time at) { return at <= oldest; }),
                       state.restarts.end());
  return state.restarts.size() >= static_cast<std::size_t>(config_.intensity.restarts);
}

void Supervisor::SetPhase(std::size_t process, ProcessPhase phase, std::string message, Time now) {
  ProcessStatus& status = states_[process].status;
  if (status.phase == phase && status.message == message) return;
  if (status.phase != phase) status.since = now;
  status.phase = phase;
  status.message = std::move(message);
  ++revision_;
}

}  // namespace coppice::robot
