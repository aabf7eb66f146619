// coppice-supervisor: starts a ROS master and the robot's programs, keeps track of them, and leaves
// nothing behind. Node /supervisor.
//
//   /processes                    coppice_msgs/ProcessStates, latched, on change and at 1 Hz
//   /supervisor/restart           coppice_msgs/RestartProcess
//   /supervisor/reset             coppice_msgs/RestartProcess, see Supervisor::Reset
//   /supervisor/set_configuration coppice_msgs/SetConfiguration
//
// One thread does everything, every 20 ms of wall time. ProcessState.since is wall time, because
// processes live in the computer's time; header.stamp is ROS time as everywhere.
#include <coppice_msgs/ProcessStates.h>
#include <coppice_msgs/RestartProcess.h>
#include <coppice_msgs/SetConfiguration.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "bt_core/base/clock.h"
#include "bt_core/base/command_line.h"
#include "robot_app/supervision/ros_master.h"
#include "robot_app/supervision/supervisor.h"

namespace coppice::robot {
namespace {

namespace fs = std::filesystem;

constexpr char kUsage[] =
    "coppice-supervisor --config FILE [--port N] [--port-file FILE] [--logs FOLDER]\n"
    "                   [--configuration NAME] [--set NAME=VALUE]...\n"
    "  --port           of the ROS master: default 11311, 0 takes a free one\n"
    "  --port-file      gets the port as text when the master answers\n"
    "  --logs           default ./logs\n"
    "  --configuration  to begin with; default: the file's\n"
    "  --set            variable of the file; bin, config and record have a value";

constexpr Duration kRound = std::chrono::milliseconds(20);
constexpr Duration kProbeDeadline = std::chrono::milliseconds(300);
constexpr Duration kReportPeriod = std::chrono::seconds(1);
constexpr Duration kMasterTimeout = std::chrono::seconds(20);

volatile std::sig_atomic_t g_stop = 0;

struct Settings {
  std::string config, port_file, logs, configuration;
  int port = 11311;
  Variables variables;
};

fs::path FolderOfThisProgram() { return fs::read_symlink("/proc/self/exe").parent_path(); }

// Takes "--set NAME=VALUE" out of the arguments; they may come several times.
bool TakeVariables(std::vector<std::string>& arguments, Variables& variables) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] != "--set") {
      others.push_back(arguments[i]);
      continue;
    }
    const std::string pair = ++i < arguments.size() ? arguments[i] : "";
    const std::size_t equals = pair.find('=');
    if (equals == 0 || equals == std::string::npos) {
      std::cerr << "coppice-supervisor: --set needs NAME=VALUE, got \"" << pair << "\"\n";
      return false;
    }
    variables[pair.substr(0, equals)] = pair.substr(equals + 1);
  }
  arguments = others;
  return true;
}

std::optional<Settings> ReadSettings(std::vector<std::string> arguments) {
  Settings settings;
  settings.variables["bin"] = FolderOfThisProgram();
  if (!TakeVariables(arguments, settings.variables)) return std::nullopt;
  const auto options = ParseOptions(
      arguments, {"--config", "--port", "--port-file", "--logs", "--configuration"}, {}, kUsage);
  if (!options) return std::nullopt;
  settings.config = options->Get("--config");
  const long port = options->GetNumber("--port").value_or(options->Has("--port") ? -1 : 11311);
  if (settings.config.empty() || port < 0 || port > 65535 || !options->files.empty()) {
    std::cerr << "usage: " << kUsage << "\n";
    return std::nullopt;
  }
  settings.port = static_cast<int>(port);
  settings.port_file = options->Get("--port-file");
  settings.logs = fs::absolute(options->Get("--logs", "logs"));
  settings.configuration = options->Get("--configuration");
  settings.variables.emplace("config", fs::absolute(settings.config).parent_path());
  settings.variables.emplace("record", settings.logs);
  return settings;
}

// The node: connects the supervisor's core to ROS.
class Node {
 public:
  Node(RobotConfig config, PosixLauncher& launcher, const RosMaster& master)
      : launcher_(launcher),
        master_(master),
        supervisor_(std::move(config), launcher),
        probe_(master.address, "/supervisor") {
    processes_ = handle_.advertise<coppice_msgs::ProcessStates>("/processes", 10, true);
    using Restart = coppice_msgs::RestartProcess;
    using Configure = coppice_msgs::SetConfiguration;
    restart_ = handle_.advertiseService<Restart::Request, Restart::Response>(
        "/supervisor/restart",
        boost::function<bool(Restart::Request&, Restart::Response&)>([this](auto& ask, auto& say) {
          return Reply(supervisor_.Restart(ask.name, clock_.Now()), "restart " + ask.name, say);
        }));
    reset_ = handle_.advertiseService<Restart::Request, Restart::Response>(
        "/supervisor/reset",
        boost::function<bool(Restart::Request&, Restart::Response&)>([this](auto& ask, auto& say) {
          return Reply(supervisor_.Reset(ask.name, clock_.Now()), "reset " + ask.name, say);
        }));
    configure_ = handle_.advertiseService<Configure::Request, Configure::Response>(
        "/supervisor/set_configuration",
        boost::function<bool(Configure::Request&, Configure::Response&)>(
            [this](auto& ask, auto& say) {
              return Reply(supervisor_.SetConfiguration(ask.configuration),
                           "set_configuration " + ask.configuration, say);
            }));
  }

  Supervisor& supervisor() { return supervisor_; }

  /// Until a signal asks to stop, and everything has stopped. Returns the exit status.
  int Run() {
    while (!g_stop && ros::ok() && !master_ended_) Round();
    supervisor_.StopAll();
    while (!supervisor_.AllStopped()) Round();
    Publish();
    if (!master_ended_) return 0;
    std::cerr << "coppice-supervisor: the ROS master ended; everything was stopped\n";
    return 1;
  }

 private:
  template <class Response>
  bool Reply(const Verdict& verdict, const std::string& request, Response& response) {
    response.ok = verdict.ok;
    response.message = verdict.message;
    std::cout << request << ": " << (verdict.ok ? "" : "refused: ") << verdict.message << std::endl;
    return true;
  }

  void Round() {
    queue().callAvailable(ros::WallDuration(std::chrono::duration<double>(kRound).count()));
    launcher_.Reap([this](int pid, int wait_status) {
      if (pid == master_.pid) master_ended_ = true;
      supervisor_.OnExit(pid, wait_status, clock_.Now());
    });
    supervisor_.Step(clock_.Now());
    ProbeStarting();
    if (supervisor_.revision() != published_ || clock_.Now() - published_at_ >= kReportPeriod) {
      Publish();
    }
  }

  static ros::CallbackQueue& queue() { return *ros::getGlobalCallbackQueue(); }

  // Asks those that were started whether they are ready.
  void ProbeStarting() {
    if (probe_.busy()) {
      if (!probe_.Work(Duration::zero())) return;
      for (std::size_t i = 0; i < probed_.size(); ++i) TakeResult(i);
      return;
    }
    std::vector<ProbeRequest> requests;
    probed_.clear();
    for (std::size_t i = 0; i < supervisor_.config().processes.size(); ++i) {
      if (!supervisor_.AwaitsReadiness(i)) continue;
      const ProcessConfig& process = supervisor_.config().processes[i];
      probed_.push_back({i, supervisor_.status(i).pid});
      requests.push_back({process.node, process.ready_topic});
    }
    if (!requests.empty()) probe_.Begin(std::move(requests), kProbeDeadline);
  }

  // The answer counts only if it comes from the process that we started: another one may have
  // registered under the same name.
  void TakeResult(std::size_t index) {
    const ProbeResult& result = probe_.results()[index];
    const auto [process, pid] = probed_[index];
    if (!result.answered || getpgid(result.pid) != pid) return;
    supervisor_.OnReady(process, pid, clock_.Now());
  }

  void Publish() {
    coppice_msgs::ProcessStates message;
    message.header.stamp = ros::Time::now();
    message.configuration = supervisor_.configuration();
    for (std::size_t i = 0; i < supervisor_.config().processes.size(); ++i) {
      const ProcessStatus& status = supervisor_.status(i);
      coppice_msgs::ProcessState state;
      state.name = supervisor_.config().processes[i].name;
      state.node = supervisor_.config().processes[i].node;
      state.state = static_cast<std::uint8_t>(status.phase);
      state.pid = status.pid;
      state.restarts = status.restarts;
      state.since.fromNSec(static_cast<std::uint64_t>(status.since.count()));
      state.message = status.message;
      message.processes.push_back(state);
      Tell(i, status);
    }
    processes_.publish(message);
    published_ = supervisor_.revision();
    published_at_ = clock_.Now();
  }

  // One line per change on the console.
  void Tell(std::size_t process, const ProcessStatus& status) {
    told_.resize(supervisor_.config().processes.size());
    const std::string line = supervisor_.config().processes[process].name + ": " +
                             ToString(status.phase) +
                             (status.pid == 0 ? "" : " (pid " + std::to_string(status.pid) + ")") +
                             (status.message.empty() ? "" : ", " + status.message);
    if (told_[process] == line) return;
    told_[process] = line;
    std::cout << line << std::endl;
  }

  struct Probed {
    std::size_t process;
    int pid;
  };

  ros::NodeHandle handle_;
  WallClock clock_;
  PosixLauncher& launcher_;
  const RosMaster& master_;
  Supervisor supervisor_;
  NodeProbe probe_;
  std::vector<Probed> probed_;
  bool master_ended_ = false;
  std::uint64_t published_ = 0;
  Time published_at_{0};
  std::vector<std::string> told_;
  ros::Publisher processes_;
  ros::ServiceServer restart_, reset_, configure_;
};

int Fail(const std::string& message) {
  std::cerr << "coppice-supervisor: " << message << "\n";
  return 2;
}

// Ends our master, if it is ours. The last one to go.
void EndMaster(const RosMaster& master, PosixLauncher& launcher) {
  if (master.pid == 0) return;
  WallClock clock;
  const Time kill_at = clock.Now() + std::chrono::seconds(3);
  launcher.Signal(master.pid, SIGTERM);
  bool ended = kill(master.pid, 0) != 0, killed = false;
  while (!ended) {
    launcher.Reap([&](int pid, int) { ended = ended || pid == master.pid; });
    if (!killed && clock.Now() >= kill_at) {
      launcher.Signal(master.pid, SIGKILL);
      killed = true;
    }
    ros::WallDuration(0.01).sleep();
  }
}

void SetParameters(const RobotConfig& config) {
  for (const auto& [name, value] : config.parameters) {
    if (value == "true" || value == "false") {
      ros::param::set("/" + name, value == "true");
    } else if (char* end = nullptr; std::strtod(value.c_str(), &end), end && *end == '\0') {
      ros::param::set("/" + name, std::strtod(value.c_str(), nullptr));
    } else {
      ros::param::set("/" + name, value);
    }
  }
}

int RunNode(RobotConfig config, const Settings& settings, const RosMaster& master,
            PosixLauncher& launcher) {
  int no_arguments = 0;
  ros::init(no_arguments, nullptr, "supervisor", ros::init_options::NoSigintHandler);
  SetParameters(config);
  Node node(std::move(config), launcher, master);
  if (!settings.configuration.empty()) {
    const Verdict verdict = node.supervisor().SetConfiguration(settings.configuration);
    if (!verdict.ok) return Fail(verdict.message);
  }
  const int status = node.Run();
  ros::shutdown();
  return status;
}

int Main(const std::vector<std::string>& arguments) {
  const auto settings = ReadSettings(arguments);
  if (!settings) return 2;
  Diagnostics diagnostics;
  RobotConfig config = LoadRobotConfig(settings->config, settings->variables, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return 2;

  struct sigaction stop {};
  stop.sa_handler = [](int) { g_stop = 1; };
  sigaction(SIGTERM, &stop, nullptr);
  sigaction(SIGINT, &stop, nullptr);
  NodeProbe::SilenceLibrary();
  PosixLauncher launcher(settings->logs);
  const RosMaster master = FindOrStartMaster(settings->port, launcher, kMasterTimeout);
  if (!master.error.empty()) return Fail(master.error);
  setenv("ROS_MASTER_URI", master.Uri().c_str(), 1);
  if (!getenv("ROS_HOSTNAME")) setenv("ROS_IP", master.address.host.c_str(), 0);
  std::cout << "ROS master: port " << master.address.port << ", ROS_MASTER_URI=" << master.Uri()
            << ", logs in " << settings->logs << std::endl;
  if (!settings->port_file.empty()) std::ofstream(settings->port_file) << master.address.port;

  const int status = RunNode(std::move(config), *settings, master, launcher);
  EndMaster(master, launcher);
  return status;
}

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) { return coppice::robot::Main({argv + 1, argv + argc}); }
