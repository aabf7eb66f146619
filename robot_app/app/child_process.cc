#include "robot_app/app/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace coppice::robot {
namespace {

// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void Become(char* const* arguments, int log, int report, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);  // the starter is already gone
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execvp(arguments[0], arguments);
  const int error = errno;
  (void)!write(report, &error, sizeof(error));
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::string& log_file,
                           const std::vector<std::pair<std::string, std::string>>& environment) {
  std::vector<std::string> words = command;
  if (!environment.empty()) {
    std::vector<std::string> prefix = {"env"};
    for (const auto& [name, value] : environment) prefix.push_back(name + "=" + value);
    words.insert(words.begin(), prefix.begin(), prefix.end());
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  const int log = open(log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log < 0) throw std::runtime_error("cannot write " + log_file + ": " + std::strerror(errno));
  int report[2];  // tells whether exec worked: closed by it, or the error
  if (pipe2(report, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) Become(arguments.data(), log, report[1], parent);
  close(log);
  close(report[1]);
  int error = 0;
  const bool failed = read(report[0], &error, sizeof(error)) == sizeof(error);
  close(report[0]);
  if (pid_ > 0 && !failed) return;
  IsRunning();
  pid_ = 0;
  throw std::runtime_error("cannot start " + command[0] + ": " + std::strerror(error));
}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  if (this == &other) return *this;
  Stop(std::chrono::seconds(2));
  pid_ = std::exchange(other.pid_, 0);
  exit_status_ = other.exit_status_;
  return *this;
}

bool ChildProcess::IsRunning() {
  if (pid_ == 0 || exit_status_ >= 0) return false;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) != pid_) return true;
  exit_status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return false;
}

int ChildProcess::Stop(std::chrono::milliseconds patience) {
  if (!IsRunning()) return exit_status_;
  kill(pid_, SIGTERM);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (IsRunning() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(-pid_, SIGKILL);  // whatever is left of its group
  while (IsRunning()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return exit_status_;
}

bool ProcessExists(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(file, line)) return false;
  const std::size_t end_of_name = line.rfind(')');
  return end_of_name != std::string::npos && line.compare(end_of_name + 2, 1, "Z") != 0;
}

}  // namespace coppice::robot
