#include "robot_app/processes/launch/remote_launcher.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace coppice::robot::processes {
namespace {

constexpr Duration kSignPeriod = std::chrono::seconds(1);
constexpr Duration kTimeToEnd = std::chrono::seconds(1);

std::string Milliseconds(Duration duration) {
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(duration).count());
}

// For a POSIX shell.
std::string Quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// A pipe that is full or broken says the same as one that is not read: the other side will notice.
void Send(int control, char sign) {
  [[maybe_unused]] const ssize_t written = write(control, &sign, 1);
}

}  // namespace

std::vector<std::string> RemoteCommand(const HostConfig& host, const ProcessConfig& process,
                                       const RemoteSettings& settings) {
  std::vector<std::string> words = {host.bin + "/coppice-remote",
                                    "--owner",
                                    settings.owner + "@" + host.name,
                                    "--name",
                                    process.name,
                                    "--stop-timeout",
                                    Milliseconds(settings.stop_timeout),
                                    "--silence",
                                    Milliseconds(kRemoteSilence),
                                    "--env",
                                    "ROS_MASTER_URI=" + settings.master_uri};
  if (!host.address.empty()) words.insert(words.end(), {"--env", "ROS_IP=" + host.address});
  words.push_back("--");
  words.insert(words.end(), process.command.begin(), process.command.end());

  std::vector<std::string> command = host.command;
  for (const std::string& word : words) command.push_back(host.shell ? Quoted(word) : word);
  return command;
}

RemoteLauncher::RemoteLauncher(PosixLauncher& local, std::vector<HostConfig> hosts,
                               RemoteSettings settings)
    : local_(local), hosts_(std::move(hosts)), settings_(std::move(settings)) {
  std::signal(SIGPIPE, SIG_IGN);  // a connection that breaks is no reason to die
}

RemoteLauncher::~RemoteLauncher() {
  while (!connections_.empty()) Forget(connections_.begin()->first);
}

Expected<int> RemoteLauncher::Start(const ProcessConfig& config) {
  if (!config.host) return local_.Start(config);
  int control[2] = {-1, -1};
  if (pipe2(control, O_CLOEXEC | O_NONBLOCK) != 0) return Problem{"no pipe to another host"};
  fcntl(control[0], F_SETFL, 0);  // the transport expects an input that blocks
  Connection connection;
  connection.control = control[1];
  connection.log = local_.log_folder() + "/" + config.log;
  std::error_code no_file;
  const auto size = std::filesystem::file_size(connection.log, no_file);
  connection.offset = no_file ? 0 : static_cast<std::size_t>(size);

  ProcessConfig transport = config;
  transport.command = RemoteCommand(hosts_[*config.host], config, settings_);
  Expected<int> pid = local_.Start(transport, control[0]);
  close(control[0]);
  if (!pid) {
    close(control[1]);
  } else {
    Forget(*pid);
    connections_[*pid] = std::move(connection);
  }
  return pid;
}

void RemoteLauncher::Signal(int pid, int signal) {
  const auto found = connections_.find(pid);
  if (found == connections_.end()) return local_.Signal(pid, signal);
  Send(found->second.control, signal == SIGKILL ? 'k' : 't');
  found->second.kill = signal == SIGKILL;
}

bool RemoteLauncher::IsConnected(int pid) const {
  const auto found = connections_.find(pid);
  if (found == connections_.end()) return true;
  const Connection& connection = found->second;
  if (!connection.connected) {
    std::ifstream log(connection.log, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::streamoff>(log.tellg());
    const auto offset = static_cast<std::streamoff>(connection.offset);
    log.seekg(size < offset ? 0 : offset);  // shorter: it was begun anew meanwhile
    std::ostringstream text;
    text << log.rdbuf();
    connection.connected = text.str().find(kRemoteStarted) != std::string::npos;
  }
  return connection.connected;
}

void RemoteLauncher::KeepAlive(Time now) {
  for (auto& [pid, connection] : connections_) {
    if (connection.kill && connection.kill_at == kNever) connection.kill_at = now + kTimeToEnd;
    if (now >= connection.kill_at) local_.Signal(pid, SIGKILL);
  }
  if (now < next_sign_) return;
  next_sign_ = now + kSignPeriod;
  for (const auto& [pid, connection] : connections_) Send(connection.control, '.');
}

void RemoteLauncher::Forget(int pid) {
  const auto found = connections_.find(pid);
  if (found == connections_.end()) return;
  close(found->second.control);
  connections_.erase(found);
}

}  // namespace coppice::robot::processes
