#include "robot_app/monitoring/node_monitor.h"

#include <algorithm>
#include <utility>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

using leaves::HealthLevel;

void NodeMonitor::Watch(const std::vector<NodeWatch>& nodes) {
  std::vector<Watched> watched;
  for (const NodeWatch& watch : nodes) {
    Watched entry;
    for (const Watched& known : nodes_) {
      if (known.watch.node == watch.node) entry = known;
    }
    entry.watch = watch;
    watched.push_back(std::move(entry));
  }
  nodes_ = std::move(watched);
}

std::vector<ProbeRequest> NodeMonitor::Requests() const {
  std::vector<ProbeRequest> requests;
  for (const Watched& node : nodes_) requests.push_back({node.watch.node, ""});
  return requests;
}

void NodeMonitor::Observe(const std::string& name, const ProbeResult& result) {
  for (Watched& node : nodes_) {
    if (node.watch.node != name) continue;
    node.misses = result.answered ? 0 : node.misses + 1;
    node.last = result;
  }
}

std::vector<Finding> NodeMonitor::Report(const ProcessTable& processes, const Times& now) {
  std::vector<Finding> findings;
  for (Watched& node : nodes_) {
    const bool is_off = node.watch.is_optional && processes.IsOff(node.watch.node);
    if (is_off || processes.IsStarting(node.watch.node)) node.misses = 0;
    Finding finding{"node", node.watch.node, node.watch.node, HealthLevel::kOk, 0, "s",
                    "",     now.ros};
    finding.value = InSeconds(node.last.delay);
    if (is_off) finding.message = kOff;
    if (node.misses > 0) {
      finding.level = node.misses >= node.watch.misses ? HealthLevel::kError : HealthLevel::kWarn;
      finding.message = node.last.reason + " (" + std::to_string(node.misses) + " pings in a row)";
    }
    ApplyGrace(processes, node.watch.node, finding);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
