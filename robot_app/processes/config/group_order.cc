#include "robot_app/processes/config/group_order.h"

#include <algorithm>

namespace coppice::robot::processes {
namespace {

void AddOnce(Indices& list, std::size_t item) {
  if (!Contains(list, item)) list.push_back(item);
}

// Everything that can be reached over `edges`, without the start unless a circle leads back to it.
Indices Reach(const std::vector<Indices>& edges, std::size_t start) {
  Indices seen, pending = {start};
  while (!pending.empty()) {
    const std::size_t item = pending.back();
    pending.pop_back();
    for (const std::size_t next : edges[item]) {
      if (Contains(seen, next)) continue;
      seen.push_back(next);
      pending.push_back(next);
    }
  }
  return seen;
}

// Direct dependencies between groups.
std::vector<Indices> Edges(const RobotConfig& config) {
  std::vector<Indices> edges(config.groups.size());
  for (std::size_t i = 0; i < config.groups.size(); ++i) edges[i] = config.groups[i].depends;
  for (const ProcessConfig& process : config.processes) {
    for (const std::size_t needed : process.depends) {
      const std::size_t group = config.processes[needed].group;
      if (group != process.group) AddOnce(edges[process.group], group);
    }
  }
  return edges;
}

}  // namespace

bool Contains(const Indices& list, std::size_t wanted) {
  return std::find(list.begin(), list.end(), wanted) != list.end();
}

GroupOrder::GroupOrder(const RobotConfig& config) : config_(config) {
  for (const ProcessConfig& process : config.processes) {
    Indices needs = process.depends;
    for (const std::size_t group : config.groups[process.group].depends) {
      for (const std::size_t member : config.groups[group].processes) AddOnce(needs, member);
    }
    needs_.push_back(std::move(needs));
  }

  const std::size_t count = config.groups.size();
  const std::vector<Indices> edges = Edges(config);
  upstream_.resize(count);
  closure_.resize(count);
  for (std::size_t group = 0; group < count; ++group) {
    upstream_[group] = Reach(edges, group);
    if (Contains(upstream_[group], group)) circular_.push_back(group);
    AddOnce(upstream_[group], group);
  }
  // A group has more above it than each of those above it: sorting by that number is an order.
  const auto earlier = [this](std::size_t a, std::size_t b) {
    return std::make_pair(upstream_[a].size(), a) < std::make_pair(upstream_[b].size(), b);
  };
  for (std::size_t group = 0; group < count; ++group) {
    std::sort(upstream_[group].begin(), upstream_[group].end(), earlier);
    for (std::size_t other = 0; other < count; ++other) {
      if (Contains(upstream_[other], group)) closure_[group].push_back(other);
    }
    std::sort(closure_[group].begin(), closure_[group].end(), earlier);
  }
}

Indices GroupOrder::Members(const Indices& groups) const {
  Indices members;
  for (const std::size_t group : groups) {
    const Indices& processes = config_.groups[group].processes;
    members.insert(members.end(), processes.begin(), processes.end());
  }
  return members;
}

Indices GroupOrder::RestartedWith(std::size_t process) const {
  const GroupConfig& group = config_.groups[config_.processes[process].group];
  if (group.strategy == Strategy::kOneForOne) return {process};
  if (group.strategy == Strategy::kOneForAll) return group.processes;
  const auto first = std::find(group.processes.begin(), group.processes.end(), process);
  return {first, group.processes.end()};
}

}  // namespace coppice::robot::processes
