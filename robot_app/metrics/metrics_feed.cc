#include "robot_app/metrics/metrics_feed.h"

#include <coppice_msgs/Health.h>
#include <coppice_msgs/HelpRequests.h>
#include <coppice_msgs/ProcessStates.h>
#include <coppice_msgs/RecoveryEvent.h>
#include <diagnostic_msgs/DiagnosticArray.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "robot_app/common/battery_message.h"

namespace coppice::robot::metrics {
namespace {

constexpr std::uint32_t kQueue = 100;

constexpr const char* kPhases[] = {"begun",   "succeeded", "failed",      "interrupted",
                                   "refused", "helped",    "did_not_help"};

void OnHealth(const coppice_msgs::Health& message, RobotMetrics& metrics) {
  std::vector<leaves::HealthEntry> entries;
  for (const coppice_msgs::HealthEntry& entry : message.entries) {
    entries.push_back({entry.monitor, entry.subject, entry.node, leaves::LevelOfNumber(entry.level),
                       entry.message});
  }
  metrics.SetHealth(entries);
}

void OnProcesses(const coppice_msgs::ProcessStates& message, RobotMetrics& metrics) {
  ProcessesFigures figures{message.configuration, message.safe_stop != 0, {}};
  for (const coppice_msgs::ProcessState& process : message.processes) {
    figures.processes.push_back({process.name, process.state, process.restarts});
  }
  metrics.SetProcesses(std::move(figures));
}

void OnRecovery(const coppice_msgs::RecoveryEvent& message, RobotMetrics& metrics) {
  if (message.phase >= std::size(kPhases)) return;
  metrics.CountRecovery(message.recovery, kPhases[message.phase]);
}

void OnRequests(const coppice_msgs::HelpRequests& message, RobotMetrics& metrics) {
  metrics.SetOpenRequests(static_cast<std::size_t>(
      std::count_if(message.requests.begin(), message.requests.end(),
                    [](const auto& request) { return request.state == request.OPEN; })));
}

void OnStore(const diagnostic_msgs::DiagnosticArray& message, RobotMetrics& metrics) {
  std::map<std::string, double> figures;
  for (const diagnostic_msgs::DiagnosticStatus& status : message.status) {
    for (const auto& pair : status.values) {
      figures[pair.key] = std::strtod(pair.value.c_str(), nullptr);
    }
  }
  metrics.SetStore(figures);
}

template <class Message>
ros::Subscriber Subscribe(ros::NodeHandle& node, const char* topic, RobotMetrics& metrics,
                          void (*use)(const Message&, RobotMetrics&)) {
  using Pointer = typename Message::ConstPtr;
  return node.subscribe<Message>(
      topic, kQueue, boost::function<void(const Pointer&)>([&metrics, use](const Pointer& message) {
        use(*message, metrics);
      }));
}

void OnBattery(const sensor_msgs::BatteryState& message, RobotMetrics& metrics) {
  metrics.SetBattery(ToBatteryReading(message, Time{}));
}

}  // namespace

std::vector<ros::Subscriber> SubscribeMetrics(ros::NodeHandle& node, RobotMetrics& metrics) {
  return {Subscribe(node, "/monitoring", metrics, OnHealth),
          Subscribe(node, "/battery_state", metrics, OnBattery),
          Subscribe(node, "/processes", metrics, OnProcesses),
          Subscribe(node, "/recovery/events", metrics, OnRecovery),
          Subscribe(node, "/assistance/requests", metrics, OnRequests),
          Subscribe(node, "/store/status", metrics, OnStore)};
}

}  // namespace coppice::robot::metrics
