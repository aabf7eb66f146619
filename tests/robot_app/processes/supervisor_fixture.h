// A supervisor whose launcher only notes what it is asked for: the test says what happens.
#ifndef COPPICE_TESTS_ROBOT_APP_PROCESSES_SUPERVISOR_FIXTURE_H_
#define COPPICE_TESTS_ROBOT_APP_PROCESSES_SUPERVISOR_FIXTURE_H_

#include <gmock/gmock.h>

#include <csignal>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/processes/supervisor.h"
#include "tests/robot_app/processes/simulated_machine.h"

namespace coppice::robot::processes {

// Wait statuses as waitpid gives them.
inline constexpr int kExit0 = 0;
inline constexpr int kExit3 = 3 << 8;
inline constexpr int kKilled = SIGKILL;

// Notes what happens; a signalled process lives on until the test says that it ended.
class NotingLauncher : public ProcessLauncher {
 public:
  Expected<int> Start(const ProcessConfig& config) override {
    log.push_back("start " + config.name);
    if (config.name == broken) return Problem{"cannot run it"};
    names[++last_pid] = config.name;
    return last_pid;
  }
  void Signal(int pid, int signal) override {
    log.push_back((signal == SIGKILL ? "kill " : "end ") + names.at(pid));
  }
  Outcome ClearState(const ProcessConfig& config) override {
    log.push_back("clear " + config.name);
    return {};
  }
  bool IsConnected(int) const override { return connected; }

  std::vector<std::string> TakeLog() { return std::exchange(log, {}); }

  std::vector<std::string> log;
  std::map<int, std::string> names;
  std::string broken;
  bool connected = true;
  int last_pid = 100;
};

// base <- nav <- app; base <- dock. "operating" has all, "charging" has base and dock.
inline RobotConfig FourProcesses() {
  RobotConfig config;
  config.processes = {MakeProcess("base"), MakeProcess("nav", {0}), MakeProcess("app", {1}),
                      MakeProcess("dock", {0})};
  AddOwnGroups(config);
  config.configurations = {{"operating", {0, 1, 2, 3}, {}}, {"charging", {0, 3}, {}}};
  return config;
}

class SupervisorTest : public testing::Test {
 protected:
  static constexpr std::size_t kBase = 0, kNav = 1, kApp = 2, kDock = 3;

  explicit SupervisorTest(RobotConfig config = FourProcesses())
      : supervisor_(std::move(config), launcher_) {}

  int Pid(std::size_t process) { return supervisor_.status(process).pid; }
  ProcessPhase Phase(std::size_t process) { return supervisor_.status(process).phase; }
  std::string Message(std::size_t process) { return supervisor_.status(process).message; }

  void Step() { supervisor_.Step(now_); }
  void Ready(std::size_t process) { supervisor_.OnReady(process, Pid(process), now_); }
  void Ended(std::size_t process, int wait_status) {
    supervisor_.OnExit(Pid(process), wait_status, now_);
    Step();
  }
  Expected<std::string> Restart(const std::string& name) {
    Expected<std::string> verdict = supervisor_.Restart(name, now_);
    Step();
    return verdict;
  }
  Expected<std::string> Configure(const std::string& name) {
    return supervisor_.SetConfiguration(name, Hand::kTree, kNoConditions);
  }
  // Ready, and up for longer than the shortest time between two starts.
  void StartAll() {
    for (int i = 0; i < 3; ++i) {
      Step();
      for (std::size_t p = 0; p < supervisor_.config().processes.size(); ++p) Ready(p);
    }
    now_ += std::chrono::seconds(10);
    launcher_.TakeLog();
  }

  NotingLauncher launcher_;
  Supervisor supervisor_;
  Time now_{std::chrono::seconds(1000)};
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_TESTS_ROBOT_APP_PROCESSES_SUPERVISOR_FIXTURE_H_
