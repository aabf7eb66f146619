// Starting and signalling processes of the operating system.
#ifndef COPPICE_ROBOT_APP_SUPERVISION_PROCESS_LAUNCHER_H_
#define COPPICE_ROBOT_APP_SUPERVISION_PROCESS_LAUNCHER_H_

#include <functional>
#include <string>

#include "robot_app/supervision/robot_config.h"

namespace coppice::robot {

class ProcessLauncher {
 public:
  virtual ~ProcessLauncher() = default;
  /// Starts a process as the leader of a process group of its own. Returns its pid, or 0 and why.
  virtual int Start(const ProcessConfig& config, std::string& error) = 0;
  /// Sends a signal to the whole group of a started process.
  virtual void Signal(int pid, int signal) = 0;
};

/// Real processes. Each has standard output and error in `<log folder>/<log>` (appended), no input,
/// none of our open files, and gets SIGTERM when the thread that started it ends, so that nothing
/// outlives its supervisor. Use it on the program's main thread only.
class PosixLauncher : public ProcessLauncher {
 public:
  /// The folder is created if needed.
  explicit PosixLauncher(std::string log_folder);

  int Start(const ProcessConfig& config, std::string& error) override;
  void Signal(int pid, int signal) override;

  /// Reports every child that has ended since the last call, also those that it did not start.
  /// What is left of the group of an ended child is killed. Does not wait.
  void Reap(const std::function<void(int pid, int wait_status)>& ended);

 private:
  std::string log_folder_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_SUPERVISION_PROCESS_LAUNCHER_H_
