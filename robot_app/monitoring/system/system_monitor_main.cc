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
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "bt_core/base/command_line.h"
#include "robot_app/common/node_probe.h"
#include "robot_app/monitoring/monitor_program.h"
#include "robot_app/monitoring/system/other_computers.h"
#include "robot_app/monitoring/system/regular_answers.h"
#include "robot_app/monitoring/system/remote_answers.h"
#include "robot_app/monitoring/system/system_monitor.h"
#include "robot_app/monitoring/system/time_server.h"

namespace coppice::robot::monitoring {
namespace {

constexpr Duration kPidDeadline = std::chrono::seconds(5);

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : computers_(start.host, ParseUri(ros::master::getURI()).value().host),
        program_(start, {&monitor_}),
        probe_(ParseUri(ros::master::getURI()).value(), ros::this_node::getName()) {
    const SystemWatch* watch = start.config.ForHost(start.host);
    monitor_.Watch(watch);
    if (watch) period_ = watch->period;
    AskSystem();
    AskOthers();
    program_.ReportRegularly([this](const Times& now) { Look(now); });
  }

 private:
  void Look(const Times& now) {
    LookForNodes();
    if (const auto sample = system_.Take()) {
      monitor_.OnSample(*sample);
      AskSystem();
    }
    if (const auto answers = remote_.Take()) {
      monitor_.OnClocks(answers->clocks, now.wall);
      monitor_.OnHosts(answers->hosts, now.wall);
    }
  }

  // Only what is new: a question begins a look at once.
  void AskSystem() {
    SystemQuestion question = monitor_.Question(pids_);
    if (period_ == Duration::zero() || question == question_) return;
    question_ = question;
    system_.Ask(std::move(question), period_);
  }

  // The nodes themselves say which processes they are and where; whoever does not answer has none.
  // A sweep goes on from round to round.
  void LookForNodes() {
    if (!probe_.busy()) return probe_.Begin(NodesToAsk(), kPidDeadline);
    if (!probe_.Work(Duration::zero())) return;
    for (std::size_t i = 0; i < probe_.requests().size(); ++i) {
      const std::string& node = probe_.requests()[i].node;
      const ProbeResult& result = probe_.results()[i];
      pids_[node] = result.pid;
      if (result.answered) computers_.OnAddress(program_.node().processes(), node, result.host);
    }
    if (monitor_.OnComputers(computers_.List(program_.node().processes()))) AskOthers();
  }

  std::vector<ProbeRequest> NodesToAsk() {
    std::vector<ProbeRequest> requests;
    for (const ProcessWatch& process : monitor_.watched().processes) {
      requests.push_back({process.node, ""});
    }
    for (const std::string& node : computers_.NodesToAsk(program_.node().processes())) {
      requests.push_back({node, ""});
    }
    return requests;
  }

  void AskOthers() {
    const SystemWatch& watch = monitor_.watched();
    RemoteQuestions questions;
    for (const ClockWatch& clock : watch.clocks) {
      questions.clocks.push_back({clock.address, clock.port});
    }
    for (const ReachWatch& host : watch.hosts) {
      questions.hosts.push_back({host.address, host.port});
    }
    questions.deadline = watch.deadline;
    const bool is_asked = !questions.clocks.empty() || !questions.hosts.empty();
    remote_.Ask(is_asked ? std::optional(std::move(questions)) : std::nullopt, watch.ask_period);
  }

  static SystemSample LookNow(const SystemQuestion& question) {
    return LookAtSystem("", question, MonitorNode::Now().wall);
  }

  SystemMonitor monitor_;
  RegularAnswers<SystemQuestion, SystemSample> system_{&LookNow};
  RegularAnswers<RemoteQuestions, RemoteAnswers> remote_{&AskComputers};
  OtherComputers computers_;
  Duration period_{0};
  std::optional<SystemQuestion> question_;
  std::map<std::string, int> pids_;
  MonitorProgram program_;
  NodeProbe probe_;
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
}  // namespace coppice::robot::monitoring

int main(int argc, char** argv) {
  using namespace coppice::robot::monitoring;  // NOLINT: the whole program
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--serve-time") != 0) continue;
    const auto options = coppice::ParseOptions(TimeCommand(), {argv + 1, argv + argc});
    return options.exit ? *options.exit : ServeTime(options);
  }
  return RunMonitor<Program>(argc, argv, "system_monitor");
}
