#include "robot_app/monitoring/monitor_node.h"

#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/poll_manager.h>
#include <ros/this_node.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <utility>

#include "bt_core/base/command_line.h"
#include "robot_app/common/find_master.h"
#include "robot_app/monitoring/aggregator/health_messages.h"
#include "robot_app/monitoring/site_bands.h"

namespace coppice::robot::monitoring {
namespace {

constexpr int kQueue = 20;
const ros::WallDuration kLongest(1);  // without looking whether the program is to end

Command MonitorCommand(std::string program) {
  std::replace(program.begin(), program.end(), '_', '-');
  return {"coppice-" + program,
          "a monitor of the robot",
          {},
          "",
          {CommandOption::Text("--config", "FILE", "what is watched").Needed(),
           CommandOption::Text("--bands", "FILE", "what the site judges otherwise"),
           CommandOption::Text("--host", "NAME", "of this computer; else that of the system"),
           CommandOption::Text("--folder", "FOLDER",
                               "where relative paths in the configuration begin; else here")}};
}

std::string HostName() {
  char name[256] = {};
  gethostname(name, sizeof(name) - 1);
  return name;
}

}  // namespace

std::optional<MonitorStart> StartMonitor(int argc, char** argv, const std::string& name) {
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
  const auto stop = [](int) { ros::requestShutdown(); };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);

  const Options options = ParseOptions(MonitorCommand(name), {argv + 1, argv + argc});
  if (options.exit == 0) std::exit(0);
  if (options.exit) return std::nullopt;
  Diagnostics diagnostics;
  MonitorStart start{LoadMonitorConfig(options.Get("--config"), diagnostics),
                     options.Get("--host", HostName()), options.Get("--folder", ".")};
  if (options.Has("--bands")) ReadSiteBands(options.Get("--bands"), start.config, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors() || !FindMaster(name)) return std::nullopt;
  return start;
}

void SpinWhenCalled() {
  while (ros::ok()) ros::getGlobalCallbackQueue()->callAvailable(kLongest);
}

void SpinInBatches(Duration batch) {
  const auto wait = [batch] { std::this_thread::sleep_for(batch); };
  // The thread that reads the sockets calls this before every look.
  ros::PollManager::instance()->addPollThreadListener(wait);
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable();
    wait();
  }
}

MonitorNode::MonitorNode(const MonitorStart& start, std::function<void(const WatchList&)> on_list)
    : start_(start), on_list_(std::move(on_list)), configuration_(start.config.initial) {
  on_list_(list());
  reports_ = handle_.advertise<coppice_msgs::Health>("/monitoring/reports", kQueue);
  subscriber_ = handle_.subscribe<coppice_msgs::ProcessStates>(
      "/processes", kQueue, [this](const coppice_msgs::ProcessStates::ConstPtr& message) {
        OnProcesses(FromMessage(*message));
      });
}

Times MonitorNode::Now() {
  return {FromRos(ros::Time::now()), Time(std::chrono::steady_clock::now().time_since_epoch())};
}

ros::WallTimer MonitorNode::Every(Duration period, std::function<void()> call) {
  return handle_.createWallTimer(ros::WallDuration(std::chrono::duration<double>(period).count()),
                                 [call = std::move(call)](const ros::WallTimerEvent&) { call(); });
}

void MonitorNode::Publish(std::vector<Finding> findings) {
  for (Finding& finding : findings) {
    if (finding.host.empty()) finding.host = processes_.HostOf(finding.node);
    if (finding.host.empty()) finding.host = start_.host;
  }
  reports_.publish(ToMessage(ros::this_node::getName(), findings));
}

void MonitorNode::OnProcesses(const ProcessTable& processes) {
  processes_ = processes;
  if (processes_.configuration == configuration_) return;
  configuration_ = processes_.configuration;
  on_list_(list());
}

}  // namespace coppice::robot::monitoring
