#include "robot_app/processes/launch/process_launcher.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "robot_app/processes/launch/survivors.h"

namespace coppice::robot {
namespace {

constexpr int kHighestInheritedFile = 1024;

// Between fork and exec only system calls are allowed: other threads may have held locks.
[[noreturn]] void BecomeProgram(char* const* arguments, char* const* environment, int input,
                                int log, int report, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);  // the supervisor died before the line above
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD, SIGPIPE, SIGHUP}) {
    std::signal(signal, SIG_DFL);
  }
  dup2(input >= 0 ? input : open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  for (int file = STDERR_FILENO + 1; file < kHighestInheritedFile; ++file) {
    if (file != report) close(file);
  }
  execvpe(arguments[0], arguments, environment);
  const int reason = errno;
  [[maybe_unused]] const ssize_t written = write(report, &reason, sizeof(reason));
  _exit(127);
}

std::vector<char*> Pointers(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

// Our environment, with one variable set.
std::vector<std::string> EnvironmentWith(const std::string& name, const std::string& value) {
  std::vector<std::string> variables = {name + "=" + value};
  for (char** variable = environ; *variable; ++variable) {
    if (std::string(*variable).rfind(name + "=", 0) != 0) variables.emplace_back(*variable);
  }
  return variables;
}

// The reason why exec failed, or 0: the pipe closes by itself when it succeeds.
int ReadReason(int pipe) {
  int reason = 0;
  ssize_t count = 0;
  do {
    count = read(pipe, &reason, sizeof(reason));
  } while (count < 0 && errno == EINTR);
  return count == sizeof(reason) ? reason : 0;
}

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

int PosixLauncher::Start(const ProcessConfig& config, std::string& error) {
  return Start(config, -1, error);
}

int PosixLauncher::Start(const ProcessConfig& config, int input, std::string& error) {
  const std::vector<char*> arguments = Pointers(config.command);
  const std::vector<std::string> variables =
      EnvironmentWith(kOwnerVariable, OwnedName(owner_, config.name));
  const std::vector<char*> environment = Pointers(variables);

  const std::string log_path = log_folder_ + "/" + config.log;
  const int log =
      config.log.empty() ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0) : OpenLog(log_path.c_str());
  int report[2] = {-1, -1};
  if (log < 0 || pipe2(report, O_CLOEXEC) != 0) {
    error = "cannot write " + log_path + ": " + std::strerror(errno);
    if (log >= 0) close(log);
    return 0;
  }
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    BecomeProgram(arguments.data(), environment.data(), input, log, report[1], parent);
  }
  int reason = pid < 0 ? errno : 0;
  close(log);
  close(report[1]);
  if (pid > 0) {
    setpgid(pid, pid);  // also here: whoever comes first
    reason = ReadReason(report[0]);
  }
  close(report[0]);
  if (reason == 0) {
    names_[pid] = config.name;
    return pid;
  }
  if (pid > 0) waitpid(pid, nullptr, 0);
  error = "cannot run " + config.command.front() + ": " + std::strerror(reason);
  return 0;
}

void PosixLauncher::Signal(int pid, int signal) {
  if (pid <= 0) return;
  kill(-pid, signal);
  // A stopped process would only see the signal when it goes on.
  if (signal == SIGTERM) kill(-pid, SIGCONT);
}

std::string PosixLauncher::ClearState(const ProcessConfig& config) {
  for (const std::string& path : config.state) {
    std::error_code error;
    std::filesystem::remove_all(path, error);
    if (error) return "cannot delete " + path + ": " + error.message();
  }
  return "";
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

}  // namespace coppice::robot
