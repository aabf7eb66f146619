// coppice-system-monitor --config FILE [--host NAME]: node /system_monitor, one for each computer;
// on the others under a name of its own (__name:=jetson_system_monitor). Measures this computer
// and asks the others, and reports every report_period of wall time.
//
// coppice-system-monitor --serve-time PORT [--address ADDRESS] [--clock-offset SECONDS]: no ROS;
// answers SNTP requests with this computer's clock until SIGTERM. Listens on loopback unless told
// otherwise.
#include <ros/ros.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "bt_core/base/command_line.h"
#include "robot_app/common/node_probe.h"
#include "robot_app/monitoring/monitor_node.h"
#include "robot_app/monitoring/system/remote_watch.h"
#include "robot_app/monitoring/system/system_monitor.h"
#include "robot_app/monitoring/system/time_server.h"

namespace coppice::robot {
namespace {

constexpr Duration kPidDeadline = std::chrono::seconds(5);

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : node_(start, [this](const WatchList& list) { Watch(list); }),
        probe_(ParseUri(ros::master::getURI()).value(), ros::this_node::getName()) {
    timer_ = node_.Every(start.config.report_period, [this] { Round(); });
  }

 private:
  void Watch(const WatchList& list) {
    const SystemWatch* watch = list.ForHost(node_.host());
    monitor_.Watch(watch);
    period_ = watch ? watch->period : Duration::zero();
    RemoteQuestions questions;
    if (watch) {
      for (const ClockWatch& clock : watch->clocks) {
        questions.clocks.push_back({clock.address, clock.port});
      }
      for (const ReachWatch& host : watch->hosts) {
        questions.hosts.push_back({host.address, host.port});
      }
      questions.period = watch->ask_period;
      questions.deadline = watch->deadline;
    }
    remote_.Ask(std::move(questions));
    nodes_.clear();
    if (!watch) return;
    for (const ProcessWatch& process : watch->processes) nodes_.push_back({process.node, ""});
  }

  void Round() {
    const Times now = MonitorNode::Now();
    if (now.wall >= next_measurement_) {
      next_measurement_ = now.wall + period_;
      monitor_.Measure(pids_, now.wall);
    }
    LookForPids();
    if (const auto answers = remote_.Take()) {
      monitor_.OnClocks(answers->clocks, now.wall);
      monitor_.OnHosts(answers->hosts, now.wall);
    }
    node_.Publish(monitor_.Report(now));
  }

  // The nodes themselves say which processes they are; whoever does not answer has none. A sweep
  // goes on from round to round.
  void LookForPids() {
    if (!probe_.busy()) return probe_.Begin(nodes_, kPidDeadline);
    if (!probe_.Work(Duration::zero())) return;
    for (std::size_t i = 0; i < probe_.requests().size(); ++i) {
      pids_[probe_.requests()[i].node] = probe_.results()[i].pid;
    }
  }

  SystemMonitor monitor_;
  RemoteWatch remote_;
  Duration period_{0};
  Time next_measurement_{0};
  std::vector<ProbeRequest> nodes_;
  std::map<std::string, int> pids_;
  MonitorNode node_;
  NodeProbe probe_;
  ros::WallTimer timer_;
};

std::atomic<bool> stop_requested{false};

const Command& TimeCommand() {
  static const Command command{
      "coppice-system-monitor",
      "serve this computer's time",
      {},
      "",
      {CommandOption::Whole("--serve-time", "PORT", 0, 65535, "answers SNTP there"),
       CommandOption::Text("--address", "ADDRESS", "listens there; else on loopback"),
       CommandOption::Real("--clock-offset", "SECONDS", -1e9, 1e9, "added to the time; else 0")}};
  return command;
}

int ServeTime(const Options& options) {
  const int port = static_cast<int>(options.Whole("--serve-time", 0));
  const std::chrono::duration<double> offset(options.Real("--clock-offset", 0));
  TimeServer server(options.Get("--address", "127.0.0.1"), port,
                    std::chrono::duration_cast<Duration>(offset));
  if (!server.error().empty()) {
    std::fprintf(stderr, "coppice-system-monitor: port %d: %s\n", port, server.error().c_str());
    return 2;
  }
  std::printf("serving time on port %d\n", server.port());
  std::fflush(stdout);
  const auto stop = [](int) { stop_requested = true; };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  while (!stop_requested) server.Work(std::chrono::milliseconds(200));
  return 0;
}

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  using namespace coppice::robot;  // NOLINT: the whole program
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--serve-time") != 0) continue;
    const auto options = coppice::ParseOptions(TimeCommand(), {argv + 1, argv + argc});
    return options.exit ? *options.exit : ServeTime(options);
  }
  const auto start = StartMonitor(argc, argv, "system_monitor");
  if (!start) return 2;
  const Program program(*start);
  coppice::robot::SpinWhenCalled();
  return 0;
}
