#include "robot_app/monitoring/process_table.h"

namespace coppice::robot::monitoring {

using leaves::HealthLevel;

bool ProcessTable::IsStarting(const std::string& node) const {
  const auto found = by_node.find(node);
  return found != by_node.end() && found->second.phase == ProcessPhase::kStarting;
}

bool ProcessTable::IsOff(const std::string& node) const {
  const auto found = by_node.find(node);
  return found != by_node.end() && found->second.phase == ProcessPhase::kStopped;
}

int ProcessTable::PidOf(const std::string& node) const {
  const auto found = by_node.find(node);
  return found == by_node.end() ? 0 : found->second.pid;
}

std::string ProcessTable::HostOf(const std::string& node) const {
  const auto found = hosts.find(node);
  return found == hosts.end() ? "" : found->second;
}

void ApplyGrace(const ProcessTable& processes, const std::string& node, Finding& finding) {
  const auto found = processes.by_node.find(node);
  if (found == processes.by_node.end()) return;
  const NodeProcess& status = found->second;
  if (status.phase == ProcessPhase::kStarting) {
    finding.level = HealthLevel::kOk;
    finding.message = "starting";
  } else if (finding.level >= HealthLevel::kError) {
    if (status.phase == ProcessPhase::kBackingOff) finding.level = HealthLevel::kWarn;
    if (!status.message.empty()) finding.message += "; process " + status.message;
  }
}

}  // namespace coppice::robot::monitoring
