#include "robot_app/common/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "robot_app/common/start_program.h"

namespace coppice::robot {

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::string& log_file,
                           const std::vector<std::pair<std::string, std::string>>& environment) {
  const int log = open(log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (log < 0) throw std::runtime_error("cannot write " + log_file + ": " + std::strerror(errno));
  const Expected<int> pid = StartProgram({command, environment, -1, log});
  close(log);
  if (!pid) throw std::runtime_error(pid.problem());
  pid_ = *pid;
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
