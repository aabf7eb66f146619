// Starting and signalling processes of the operating system.
#ifndef COPPICE_ROBOT_APP_PROCESSES_LAUNCH_PROCESS_LAUNCHER_H_
#define COPPICE_ROBOT_APP_PROCESSES_LAUNCH_PROCESS_LAUNCHER_H_

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/processes/config/robot_config.h"

namespace coppice::robot::processes {

class ProcessLauncher {
 public:
  virtual ~ProcessLauncher() = default;
  /// Starts a process as the leader of a process group of its own. Returns its pid.
  virtual Expected<int> Start(const ProcessConfig& config) = 0;
  /// Sends a signal to the whole group of a started process.
  virtual void Signal(int pid, int signal) = 0;
  /// Deletes what the process remembers (ProcessConfig::state).
  virtual Outcome ClearState(const ProcessConfig& config) = 0;
  /// For a process on another host: it is known to have been started there.
  virtual bool IsConnected(int pid) const = 0;
};

/// Real processes. Each has standard output and error in `<log folder>/<log>` (appended; our own
/// output if it names no log, or its log cannot be written: a disk that is full is no reason not to
/// start), no input, none of our open files, and gets SIGTERM when the thread that started it ends,
/// so that nothing outlives its supervisor. Use it on the program's main thread only.
class PosixLauncher : public ProcessLauncher {
 public:
  /// A longer log begins anew; what it held last, up to as many bytes, is then in `<log>.1`.
  static constexpr std::int64_t kMostLogBytes = 16 << 20;

  /// The folder is created if needed. With an `owner`, which must be unique on this computer, every
  /// process carries it in its environment (survivors.h), and what a process leaves behind when it
  /// ends is found even if it has left its process group.
  explicit PosixLauncher(std::string log_folder, std::string owner = "");

  Expected<int> Start(const ProcessConfig& config) override { return Start(config, -1); }
  /// The same with a file as standard input, or none if it is negative. The caller closes it.
  Expected<int> Start(const ProcessConfig& config, int input);
  void Signal(int pid, int signal) override;
  Outcome ClearState(const ProcessConfig& config) override;
  bool IsConnected(int) const override { return true; }

  /// Reports every child that has ended since the last call, also those that it did not start.
  /// What is left of an ended process is killed. Does not wait.
  void Reap(const std::function<void(int pid, int wait_status)>& ended);

  /// Begins logs anew that have grown too long. To be called every second or so. What a process
  /// says in the moment between the copy and the new beginning is lost.
  void KeepLogsShort();

  const std::string& log_folder() const { return log_folder_; }

 private:
  int OpenOutput(const ProcessConfig& config);

  std::string log_folder_;
  std::string owner_;
  std::set<std::string> logs_;        // paths of those that were opened
  std::map<int, std::string> names_;  // of what was started, by pid
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_LAUNCH_PROCESS_LAUNCHER_H_
