// coppice-remote: guards one process on this host for a process supervisor on another one, which
// talks to it over its standard input. See remote_launcher.h. Not to be called by people.
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "bt_core/base/clock.h"
#include "bt_core/base/command_line.h"
#include "robot_app/processes/launch/process_launcher.h"
#include "robot_app/processes/launch/remote_launcher.h"
#include "robot_app/processes/launch/survivors.h"

namespace coppice::robot::processes {
namespace {

const Command& RemoteCommand() {
  static const Command command{
      "coppice-remote",
      "guard one process for a supervisor on another computer",
      {"-- PROGRAM [ARGUMENT]...", 1, kAnyNumber},
      "",
      {CommandOption::Text("--owner", "NAME", "the supervisor").Needed(),
       CommandOption::Text("--name", "NAME", "of the process").Needed(),
       CommandOption::Whole("--stop-timeout", "MS", 0, 1e9, "from SIGTERM to SIGKILL").Needed(),
       CommandOption::Whole("--silence", "MS", 0, 1e9, "of the supervisor, that ends it").Needed(),
       CommandOption::Text("--env", "NAME=VALUE", "for it; may be given several times")}};
  return command;
}

constexpr int kRoundMs = 20;
constexpr int kCannotRun = 127;     // as a shell says it
constexpr int kNoConnection = 255;  // is what the transport says, so we do not
constexpr Duration kTimeForSurvivors = std::chrono::seconds(3);

class Guard {
 public:
  Guard(PosixLauncher& launcher, int pid, Duration stop_timeout, Duration silence)
      : launcher_(launcher),
        pid_(pid),
        stop_timeout_(stop_timeout),
        silence_(silence),
        heard_at_(clock_.Now()) {}

  /// Until the process has ended. Returns its wait status.
  int Run() {
    while (!status_) {
      Listen();
      if (clock_.Now() - heard_at_ >= silence_) connected_ = false;
      if (!connected_ && !kill_at_) End();
      if (kill_at_ && clock_.Now() >= *kill_at_) launcher_.Signal(pid_, SIGKILL);
      launcher_.Reap([this](int pid, int status) {
        if (pid == pid_) status_ = status;
      });
    }
    return *status_;
  }

 private:
  void Listen() {
    pollfd input{connected_ ? STDIN_FILENO : -1, POLLIN, 0};
    if (poll(&input, 1, kRoundMs) <= 0) return;
    char signs[64];
    const ssize_t count = read(STDIN_FILENO, signs, sizeof(signs));
    connected_ = count > 0;
    heard_at_ = clock_.Now();
    for (ssize_t i = 0; i < count; ++i) {
      if (signs[i] == 't') launcher_.Signal(pid_, SIGTERM);
      if (signs[i] == 'k') launcher_.Signal(pid_, SIGKILL);
    }
  }

  void End() {
    launcher_.Signal(pid_, SIGTERM);
    kill_at_ = clock_.Now() + stop_timeout_;
  }

  WallClock clock_;
  PosixLauncher& launcher_;
  const int pid_;
  const Duration stop_timeout_, silence_;
  Time heard_at_;
  bool connected_ = true;
  std::optional<Time> kill_at_;
  std::optional<int> status_;
};

int ExitStatus(int wait_status) {
  if (WIFSIGNALED(wait_status)) return 128 + WTERMSIG(wait_status);
  return WEXITSTATUS(wait_status) == kNoConnection ? kNoConnection - 1 : WEXITSTATUS(wait_status);
}

bool SetEnvironment(const std::vector<std::string>& variables) {
  for (const std::string& variable : variables) {
    const std::size_t equals = variable.find('=');
    if (equals == std::string::npos) return false;
    setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  return true;
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(RemoteCommand(), arguments);
  if (options.exit) return *options.exit;
  ProcessConfig process;
  process.command = options.files;
  process.name = options.Get("--name");
  const std::string owner = options.Get("--owner");
  if (!SetEnvironment(options.GetAll("--env"))) {
    return RefuseOptions(RemoteCommand(), "--env: expected NAME=VALUE");
  }
  for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_IGN);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  KillOwned(OwnedName(owner, process.name), kTimeForSurvivors);
  // An earlier guard cleans up after its own process only, not after ours.
  PosixLauncher launcher("", OwnedName(owner, process.name) + std::to_string(getpid()));
  const Expected<int> pid = launcher.Start(process);
  std::cout << kRemoteStarted << process.name << std::endl;
  if (!pid) {
    std::cerr << "coppice-remote: " << pid.problem() << std::endl;
    return kCannotRun;
  }
  return ExitStatus(Guard(launcher, *pid,
                          std::chrono::milliseconds(options.Whole("--stop-timeout", 0)),
                          std::chrono::milliseconds(options.Whole("--silence", 0)))
                        .Run());
}

}  // namespace
}  // namespace coppice::robot::processes

int main(int argc, char** argv) { return coppice::robot::processes::Main({argv + 1, argv + argc}); }
