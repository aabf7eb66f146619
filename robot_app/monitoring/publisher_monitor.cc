#include "robot_app/monitoring/publisher_monitor.h"

#include <algorithm>
#include <utility>

namespace coppice::robot::monitoring {
namespace {

constexpr Duration kHolds = std::chrono::seconds(5);

std::string Join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

void PublisherMonitor::Watch(const std::vector<PublisherWatch>& topics) {
  std::vector<Watched> watched;
  for (const PublisherWatch& watch : topics) {
    Watched entry{watch, "", {}};
    for (const Watched& known : topics_) {
      if (known.watch == watch) entry = known;
    }
    watched.push_back(std::move(entry));
  }
  topics_ = std::move(watched);
}

void PublisherMonitor::OnMessage(const std::string& topic, const std::string& node,
                                 const Times& now) {
  for (Watched& entry : topics_) {
    const std::vector<std::string>& may = entry.watch.nodes;
    if (entry.watch.topic != topic || std::find(may.begin(), may.end(), node) != may.end()) {
      continue;
    }
    entry.stranger = node;
    entry.heard_at = now.wall;
  }
}

std::vector<Finding> PublisherMonitor::Report(const ProcessTable&, const Times& now) {
  std::vector<Finding> findings;
  for (const Watched& entry : topics_) {
    Finding finding{"publisher", entry.watch.topic, ""};
    finding.stamp = now.ros;
    if (!entry.stranger.empty() && now.wall - entry.heard_at < kHolds) {
      finding.level = leaves::HealthLevel::kError;
      finding.message =
          entry.stranger + " publishes here, where only " + Join(entry.watch.nodes) + " may";
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
