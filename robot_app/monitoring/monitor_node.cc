#include "robot_app/monitoring/monitor_node.h"

#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include <csignal>
#include <iostream>
#include <utility>

#include "bt_core/base/command_line.h"
#include "robot_app/monitoring/health_messages.h"
#include "robot_app/supervision/node_probe.h"

namespace coppice::robot {
namespace {

constexpr int kQueue = 20;

bool FindMaster(const std::string& name) {
  const std::string& uri = ros::master::getURI();
  const auto master = ParseUri(uri);
  if (master && MasterAnswers(*master, std::chrono::seconds(2))) return true;
  std::cerr << name << ": no ROS master at " << uri << " (ROS_MASTER_URI)\n";
  return false;
}

}  // namespace

std::optional<MonitorConfig> StartMonitor(int argc, char** argv, const std::string& name) {
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  const auto stop = [](int) { ros::requestShutdown(); };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  NodeProbe::SilenceLibrary();

  const auto options = ParseOptions({argv + 1, argv + argc}, {"--config"}, {}, "--config FILE");
  if (!options) return std::nullopt;
  if (!options->Has("--config") || !options->files.empty()) {
    std::cerr << "usage: " << argv[0] << " --config FILE\n";
    return std::nullopt;
  }
  Diagnostics diagnostics;
  MonitorConfig config = LoadMonitorConfig(options->Get("--config"), diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors() || !FindMaster(name)) return std::nullopt;
  return config;
}

MonitorNode::MonitorNode(const MonitorConfig& config, std::function<void(const WatchList&)> on_list)
    : config_(config), on_list_(std::move(on_list)), configuration_(config.initial) {
  on_list_(config_.ForConfiguration(configuration_));
  reports_ = handle_.advertise<coppice_msgs::Health>("/monitoring/reports", kQueue);
  subscriber_ = handle_.subscribe<coppice_msgs::ProcessStates>(
      "/processes", kQueue, [this](const coppice_msgs::ProcessStates::ConstPtr& message) {
        OnProcesses(FromMessage(*message));
      });
}

Times MonitorNode::Now() {
  return {FromRos(ros::Time::now()), std::chrono::steady_clock::now().time_since_epoch()};
}

void MonitorNode::Publish(const std::vector<Finding>& findings) {
  reports_.publish(ToMessage(ros::this_node::getName(), findings));
}

void MonitorNode::OnProcesses(const ProcessTable& processes) {
  processes_ = processes;
  if (processes_.configuration == configuration_) return;
  configuration_ = processes_.configuration;
  on_list_(config_.ForConfiguration(configuration_));
}

}  // namespace coppice::robot
