// Processes on other hosts through the same interface as those of this one.
//
// The transport is a command of the configuration file (HostConfig::command, such as ssh). It runs
// coppice-remote on the other host, which guards the process there: it ends an earlier instance
// first, then starts the process and says so, and does what comes over its standard input.
//
//   t   SIGTERM to the process and its group         k   SIGKILL
//   .   the supervisor is alive; once a second
//
// When its input ends, or nothing comes for kSilence, the connection is lost: it ends the process,
// so that nothing runs on a host that nobody controls. Its exit status is that of the process,
// never 255, which is what a transport without a connection returns.
#ifndef COPPICE_ROBOT_APP_PROCESSES_LAUNCH_REMOTE_LAUNCHER_H_
#define COPPICE_ROBOT_APP_PROCESSES_LAUNCH_REMOTE_LAUNCHER_H_

#include <map>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/processes/config/robot_config.h"
#include "robot_app/processes/launch/process_launcher.h"

namespace coppice::robot::processes {

/// What coppice-remote writes into the log when the process was started.
inline constexpr char kRemoteStarted[] = "coppice-remote: started ";
inline constexpr Duration kRemoteSilence = std::chrono::seconds(10);

struct RemoteSettings {
  std::string owner;       ///< as that of the local launcher
  std::string master_uri;  ///< ROS_MASTER_URI as other hosts see it
  Duration stop_timeout{0};
};

/// The whole command: transport, coppice-remote, process.
std::vector<std::string> RemoteCommand(const HostConfig& host, const ProcessConfig& process,
                                       const RemoteSettings& settings);

/// Starts processes of this host by the local launcher, and all others by their transport. Its pids
/// are those of the transports.
class RemoteLauncher : public ProcessLauncher {
 public:
  /// The local launcher must outlive it.
  RemoteLauncher(PosixLauncher& local, std::vector<HostConfig> hosts, RemoteSettings settings);
  ~RemoteLauncher() override;
  RemoteLauncher(const RemoteLauncher&) = delete;
  RemoteLauncher& operator=(const RemoteLauncher&) = delete;

  Expected<int> Start(const ProcessConfig& config) override;
  /// A transport that does not end soon after SIGKILL was sent over it is killed itself.
  void Signal(int pid, int signal) override;
  Outcome ClearState(const ProcessConfig& config) override { return local_.ClearState(config); }
  bool IsConnected(int pid) const override;

  /// Tells the other hosts that we are alive. Every round.
  void KeepAlive(Time now);
  /// A process has ended; its pid means nothing any more.
  void Forget(int pid);

 private:
  struct Connection {
    int control = -1;        // the transport's standard input
    std::string log;         // where the other side says that it has started
    std::size_t offset = 0;  // of the part that is from this connection
    mutable bool connected = false;
    bool kill = false;      // was asked for
    Time kill_at = kNever;  // the transport itself
  };

  PosixLauncher& local_;
  const std::vector<HostConfig> hosts_;
  const RemoteSettings settings_;
  std::map<int, Connection> connections_;  // by pid of the transport
  Time next_sign_{};
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_LAUNCH_REMOTE_LAUNCHER_H_
