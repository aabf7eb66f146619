#include "robot_app/monitoring/aggregator/health_messages.h"

#include <algorithm>
#include <utility>

namespace coppice::robot::monitoring {

Time FromRos(const ros::Time& time) {
  return TimeFromNanoseconds(static_cast<std::int64_t>(time.toNSec()));
}

ros::Time ToRos(Time time) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(ToNanoseconds(std::max(Time{}, time))));
}

coppice_msgs::Health ToMessage(const std::string& source, const std::vector<Finding>& findings) {
  coppice_msgs::Health message;
  message.header.stamp = ros::Time::now();
  message.source = source;
  for (const Finding& finding : findings) {
    coppice_msgs::HealthEntry entry;
    entry.monitor = finding.monitor;
    entry.subject = finding.subject;
    entry.node = finding.node;
    entry.level = static_cast<std::uint8_t>(finding.level);
    entry.value = finding.value;
    entry.unit = finding.unit;
    entry.message = finding.message;
    entry.stamp = ToRos(finding.stamp);
    entry.host = finding.host;
    message.entries.push_back(std::move(entry));
  }
  return message;
}

std::vector<Finding> FromMessage(const coppice_msgs::Health& message) {
  std::vector<Finding> findings;
  for (const coppice_msgs::HealthEntry& entry : message.entries) {
    Finding finding{entry.monitor, entry.subject, entry.node,    leaves::LevelOfNumber(entry.level),
                    entry.value,   entry.unit,    entry.message, FromRos(entry.stamp),
                    entry.host};
    findings.push_back(std::move(finding));
  }
  return findings;
}

ProcessTable FromMessage(const coppice_msgs::ProcessStates& message) {
  ProcessTable table;
  table.configuration = message.configuration;
  for (const coppice_msgs::ProcessState& state : message.processes) {
    if (state.node.empty()) continue;
    if (!state.host.empty()) table.hosts[state.node] = state.host;
    NodeProcess& status = table.by_node[state.node];
    status.phase = static_cast<ProcessPhase>(state.state);
    status.pid = state.pid;
    status.message = state.message;
  }
  return table;
}

}  // namespace coppice::robot::monitoring
