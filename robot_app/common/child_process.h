// A program started by this one: it dies with its starter, and leaves no children of its own
// behind.
#ifndef COPPICE_ROBOT_APP_COMMON_CHILD_PROCESS_H_
#define COPPICE_ROBOT_APP_COMMON_CHILD_PROCESS_H_

#include <sys/types.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace coppice::robot {

class ChildProcess {
 public:
  ChildProcess() = default;
  /// Starts a program with its output in a file, in a process group of its own. Throws
  /// std::runtime_error if the program cannot be started.
  ChildProcess(const std::vector<std::string>& command, const std::string& log_file,
               const std::vector<std::pair<std::string, std::string>>& environment = {});
  ~ChildProcess() { Stop(std::chrono::seconds(2)); }
  ChildProcess(ChildProcess&& other) noexcept { *this = std::move(other); }
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  pid_t pid() const { return pid_; }

  /// True while it runs. Once false, exit_status() is known.
  bool IsRunning();

  /// Exit status, or 128 + signal as a shell would say; -1 while it runs.
  int exit_status() const { return exit_status_; }

  /// SIGTERM, and SIGKILL to its whole group after the time. Returns the exit status.
  int Stop(std::chrono::milliseconds patience);

 private:
  pid_t pid_ = 0;
  int exit_status_ = -1;
};

/// True if a process with that number exists and is not a zombie.
bool ProcessExists(pid_t pid);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_CHILD_PROCESS_H_
