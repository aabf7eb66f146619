#include "robot_app/processes/launch/process_launcher.h"

#include <fcntl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <utility>

#include "robot_app/common/start_program.h"
#include "robot_app/processes/launch/survivors.h"

namespace coppice::robot::processes {
namespace {

// For its owner alone: what a program prints may be secret. Somebody may have put a link to another
// file into a folder like /tmp, or a pipe that nobody reads.
int OpenLog(const std::string& path, int flags) {
  const int log = open(path.c_str(), O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | flags, 0600);
  struct stat status {};
  if (log < 0) return log;
  if (fstat(log, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 1 &&
      status.st_uid == geteuid()) {
    fchmod(log, 0600);
    return log;
  }
  close(log);
  errno = EPERM;
  return -1;
}

// Without reading it into memory. On a full disk only a part arrives.
void CopyEnd(int from, std::int64_t size, std::int64_t most, int to) {
  off_t offset = std::max<std::int64_t>(0, size - most);
  while (offset < size) {
    if (sendfile(to, from, &offset, static_cast<std::size_t>(size - offset)) <= 0) return;
  }
}

// Those who write at its end go on at the new beginning.
void BeginAnewIfLong(const std::string& path, std::int64_t most) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_size <= most) {
    return;
  }
  const int log = OpenLog(path, O_RDWR);
  const int kept = OpenLog(path + ".1", O_WRONLY);
  if (log >= 0 && kept >= 0 && ftruncate(kept, 0) == 0) CopyEnd(log, status.st_size, most, kept);
  if (log >= 0 && ftruncate(log, 0) != 0) {
    std::cerr << "cannot shorten " << path << ": " << std::strerror(errno) << "\n";
  }
  if (log >= 0) close(log);
  if (kept >= 0) close(kept);
}

}  // namespace

PosixLauncher::PosixLauncher(std::string log_folder, std::string owner)
    : log_folder_(std::move(log_folder)), owner_(std::move(owner)) {
  std::error_code ignored;  // a missing folder is reported by the first start
  if (!log_folder_.empty()) std::filesystem::create_directories(log_folder_, ignored);
}

Expected<int> PosixLauncher::Start(const ProcessConfig& config, int input) {
  const int log = OpenOutput(config);
  Expected<int> pid = StartProgram(
      {config.command, {{kOwnerVariable, OwnedName(owner_, config.name)}}, input, log});
  close(log);
  if (pid) names_[*pid] = config.name;
  return pid;
}

// Where what it says goes.
int PosixLauncher::OpenOutput(const ProcessConfig& config) {
  if (!config.log.empty()) {
    const std::string path = log_folder_ + "/" + config.log;
    const int log = OpenLog(path, O_WRONLY | O_APPEND);
    if (log >= 0) {
      logs_.insert(path);
      return log;
    }
    std::cerr << "cannot write " << path << ": " << std::strerror(errno) << "; what " << config.name
              << " says is here\n";
  }
  return fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
}

void PosixLauncher::KeepLogsShort() {
  for (const std::string& log : logs_) BeginAnewIfLong(log, kMostLogBytes);
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
