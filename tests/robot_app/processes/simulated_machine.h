// A computer in simulated time for tests of the process supervisor: programs load, crash and end
// after times that the test says, and whatever must never happen is a failure of the test.
#ifndef COPPICE_TESTS_ROBOT_APP_PROCESSES_SIMULATED_MACHINE_H_
#define COPPICE_TESTS_ROBOT_APP_PROCESSES_SIMULATED_MACHINE_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/processes/supervisor.h"

namespace coppice::robot::processes {

inline ProcessConfig MakeProcess(const std::string& name, Indices depends = {}) {
  ProcessConfig process;
  process.name = name;
  process.command = {name};
  process.node = "/" + name + "_node";
  process.depends = std::move(depends);
  return process;
}

/// Gives every process that has none a group of its own.
inline void AddOwnGroups(RobotConfig& config) {
  for (std::size_t i = 0; i < config.processes.size(); ++i) {
    config.processes[i].group = i;
    GroupConfig group;
    group.name = config.processes[i].name;
    group.processes = {i};
    config.groups.push_back(group);
  }
}

inline const CheckCondition kNoConditions = [](std::size_t) { return Outcome(); };

/// How a program behaves.
struct Program {
  Duration loads = std::chrono::seconds(1);        ///< until it is ready
  Duration ends = std::chrono::milliseconds(200);  ///< after SIGTERM
  bool ignores_term = false;
  bool hangs = false;  ///< once it is ready
  /// How long after this start it crashes, or never.
  std::function<std::optional<Duration>()> crashes = [] { return std::nullopt; };
};

class SimulatedMachine : public ProcessLauncher {
 public:
  Expected<int> Start(const ProcessConfig& config) override {
    for (const auto& [pid, life] : alive_) {
      EXPECT_NE(life.name, config.name) << "two instances";
    }
    if (supervisor != nullptr) ExpectDependenciesHold(config);
    starts.emplace_back(config.name, now);
    const Program& program = programs[config.name];
    Life life;
    life.name = config.name;
    life.ready = now + program.loads;
    if (const auto crash = program.crashes()) life.ends = now + *crash;
    alive_[++last_pid_] = life;
    return last_pid_;
  }

  void Signal(int pid, int signal) override {
    Life& life = alive_.at(pid);
    const Program& program = programs[life.name];
    log.push_back((signal == SIGKILL ? "kill " : "end ") + life.name);
    if (signal == SIGTERM && program.ignores_term) return;
    const Duration needed = signal == SIGKILL ? std::chrono::milliseconds(1) : program.ends;
    life.ends = std::min(life.ends, now + needed);
    life.status = signal;
  }

  Outcome ClearState(const ProcessConfig& config) override {
    log.push_back("clear " + config.name);
    if (on_clear) on_clear(config.name);
    return {};
  }

  bool IsConnected(int) const override { return true; }

  /// Lets the supervisor know what happened until now, and do what is due.
  void Round() {
    std::vector<std::pair<int, int>> ended;
    for (const auto& [pid, life] : alive_) {
      if (life.ends <= now) ended.emplace_back(pid, life.status);
    }
    for (const auto& [pid, status] : ended) {
      alive_.erase(pid);
      supervisor->OnExit(pid, status, now);
    }
    for (std::size_t i = 0; i < supervisor->config().processes.size(); ++i) {
      const int pid = supervisor->status(i).pid;
      if (pid == 0 || alive_.at(pid).ready > now) continue;
      supervisor->OnReady(i, pid, now);
      if (!programs[alive_.at(pid).name].hangs) supervisor->OnHeartbeat(i, now);
    }
    supervisor->Step(now);
  }

  bool Runs(const std::string& name) const {
    return std::any_of(alive_.begin(), alive_.end(),
                       [&name](const auto& entry) { return entry.second.name == name; });
  }
  void Crash(const std::string& name) {
    for (auto& [pid, life] : alive_) {
      if (life.name == name) life.ends = now;
    }
  }

  int Starts(const std::string& name) const {
    return static_cast<int>(std::count_if(starts.begin(), starts.end(),
                                          [&](const auto& start) { return start.first == name; }));
  }

  Time now{std::chrono::seconds(1000)};
  std::map<std::string, Program> programs;
  std::function<void(const std::string& name)> on_clear;
  std::vector<std::pair<std::string, Time>> starts;
  std::vector<std::string> log;  ///< signals and what was cleared
  Supervisor* supervisor = nullptr;

 private:
  struct Life {
    std::string name;
    Time ready{};
    Time ends = kNever;
    int status = SIGSEGV;
  };

  void ExpectDependenciesHold(const ProcessConfig& config) const {
    for (const std::size_t needed : config.depends) {
      EXPECT_EQ(supervisor->status(needed).phase, ProcessPhase::kReady)
          << config.name << " starts without " << supervisor->config().processes[needed].name;
    }
  }

  std::map<int, Life> alive_;
  int last_pid_ = 100;
};

/// A supervisor on that machine, as its program runs it: with a restart of the whole stack comes a
/// new supervisor that knows what the old one has written down.
class SimulatedRobot {
 public:
  explicit SimulatedRobot(RobotConfig config) : config_(std::move(config)) { Begin({}); }

  Supervisor& supervisor() { return *supervisor_; }

  void RunFor(Duration duration) {
    RunUntil([] { return false; }, duration);
  }

  /// True when it has come true; false after the duration.
  bool RunUntil(const std::function<bool()>& condition, Duration at_most) {
    const Time end = machine.now + at_most;
    while (!condition()) {
      if (machine.now >= end) return false;
      machine.now += std::chrono::milliseconds(50);
      machine.Round();
      for (std::string& call : supervisor_->TakeCalls()) calls.push_back(std::move(call));
      if (supervisor_->NeedsNewStack(machine.now)) {
        ++stacks;
        if (on_new_stack) on_new_stack();
        Begin(supervisor_->Remember());
      }
    }
    return true;
  }

  ProcessPhase Phase(const std::string& name) const {
    return supervisor_->status(Index(name)).phase;
  }
  std::size_t Index(const std::string& name) const {
    for (std::size_t i = 0; i < config_.processes.size(); ++i) {
      if (config_.processes[i].name == name) return i;
    }
    ADD_FAILURE() << name;
    return 0;
  }
  bool AllReady() const {
    for (const std::size_t i :
         config_.configurations[supervisor_->configuration_switch().current()].processes) {
      if (supervisor_->status(i).phase != ProcessPhase::kReady) return false;
    }
    return true;
  }

  /// The supervisor is killed, with all its children; another one begins with what it left.
  void Begin(const SupervisorMemory& memory) {
    const auto read_back = MemoryFromText(ToText(memory), machine.now);
    supervisor_ = std::make_unique<Supervisor>(config_, machine, read_back.value());
    machine.supervisor = supervisor_.get();
  }

  SimulatedMachine machine;
  std::function<void()> on_new_stack;
  int stacks = 0;  ///< how often the whole stack was restarted
  std::vector<std::string> calls;

 private:
  const RobotConfig config_;
  std::unique_ptr<Supervisor> supervisor_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_TESTS_ROBOT_APP_PROCESSES_SIMULATED_MACHINE_H_
