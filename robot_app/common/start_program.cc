#include "robot_app/common/start_program.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace coppice::robot {
namespace {

constexpr int kHighestInheritedFile = 1024;

// Between fork and exec only system calls are allowed: other threads may have held locks.
[[noreturn]] void BecomeProgram(char* const* arguments, char* const* environment, int input,
                                int output, int report, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);  // the starter died before the line above
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD, SIGPIPE, SIGHUP}) {
    std::signal(signal, SIG_DFL);
  }
  dup2(input >= 0 ? input : open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
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

// Our environment, with some variables set.
std::vector<std::string> EnvironmentWith(
    const std::vector<std::pair<std::string, std::string>>& set) {
  std::vector<std::string> variables;
  for (const auto& [name, value] : set) variables.push_back(name + "=" + value);
  for (char** variable = environ; *variable; ++variable) {
    const std::string ours = *variable;
    const bool is_set = std::any_of(set.begin(), set.end(), [&ours](const auto& pair) {
      return ours.rfind(pair.first + "=", 0) == 0;
    });
    if (!is_set) variables.push_back(ours);
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

}  // namespace

Expected<int> StartProgram(const ProgramStart& start) {
  const std::vector<std::string> variables = EnvironmentWith(start.environment);
  const std::vector<char*> arguments = Pointers(start.command), environment = Pointers(variables);
  int report[2] = {-1, -1};
  if (pipe2(report, O_CLOEXEC) != 0) {
    return Problem{std::string("no pipe: ") + std::strerror(errno)};
  }
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    BecomeProgram(arguments.data(), environment.data(), start.input, start.output, report[1],
                  parent);
  }
  int reason = pid < 0 ? errno : 0;
  close(report[1]);
  if (pid > 0) {
    setpgid(pid, pid);  // also here: whoever comes first
    reason = ReadReason(report[0]);
  }
  close(report[0]);
  if (reason == 0) return pid;
  if (pid > 0) waitpid(pid, nullptr, 0);
  return Problem{"cannot run " + start.command.front() + ": " + std::strerror(reason)};
}

}  // namespace coppice::robot
