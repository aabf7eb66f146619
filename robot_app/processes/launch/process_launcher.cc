#include "robot_app/processes/launch/process_launcher.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include "robot_app/common/start_program.h"
#include "robot_app/processes/launch/survivors.h"

namespace coppice::robot::processes {
namespace {

// For its owner alone: what a program prints may be secret.
int OpenLog(const char* path) {
  const int log = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (log >= 0) fchmod(log, 0600);
  return log;
}

}  // namespace

PosixLauncher::PosixLauncher(std::string log_folder, std::string owner)
    : log_folder_(std::move(log_folder)), owner_(std::move(owner)) {
  std::error_code ignored;  // a missing folder is reported by the first start
  if (!log_folder_.empty()) std::filesystem::create_directories(log_folder_, ignored);
}

Expected<int> PosixLauncher::Start(const ProcessConfig& config, int input) {
  const std::string log_path = log_folder_ + "/" + config.log;
  const int log =
      config.log.empty() ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0) : OpenLog(log_path.c_str());
  if (log < 0) return Problem{"cannot write " + log_path + ": " + std::strerror(errno)};
  Expected<int> pid = StartProgram(
      {config.command, {{kOwnerVariable, OwnedName(owner_, config.name)}}, input, log});
  close(log);
  if (pid) names_[*pid] = config.name;
  return pid;
}

void PosixLauncher::Signal(int pid, int signal) {
  if (pid <= 0) return;
  kill(-pid, signal);
  // A stopped process would only see the signal when it goes on.
  if (signal == SIGTERM) kill(-pid, SIGCONT);
}

Outcome PosixLauncher::ClearState(const ProcessConfig& config) {
  for (const std::string& path : config.state) {
    std::error_code error;
    std::filesystem::remove_all(path, error);
    if (error) return Problem{"cannot delete " + path + ": " + error.message()};
  }
  return {};
}

void PosixLauncher::Reap(const std::function<void(int pid, int wait_status)>& ended) {
  int wait_status = 0;
  pid_t pid = 0;
  while ((pid = waitpid(-1, &wait_status, WNOHANG)) > 0) {
    kill(-pid, SIGKILL);
    const auto name = names_.find(pid);
    if (name != names_.end()) {
      if (!owner_.empty()) {
        for (const int left : FindOwned(OwnedName(owner_, name->second))) kill(left, SIGKILL);
      }
      names_.erase(name);
    }
    ended(pid, wait_status);
  }
}

}  // namespace coppice::robot::processes
