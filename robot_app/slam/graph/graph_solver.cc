#include "robot_app/slam/graph/graph_solver.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace coppice::robot::slam {

void GraphSolver::AddPose() {
  links_of_.emplace_back();
  is_rough_.push_back(false);
}

void GraphSolver::AddLink(const PoseGraph& graph) {
  const auto index = static_cast<std::uint32_t>(graph.links.size() - 1);
  links_of_[graph.links.back().from].push_back(index);
  links_of_[graph.links.back().to].push_back(index);
}

void GraphSolver::DropLink(const PoseGraph& graph) {
  links_of_[graph.links.back().from].pop_back();
  links_of_[graph.links.back().to].pop_back();
}

SolverWork GraphSolver::TakeWork() { return std::exchange(work_, {}); }

bool GraphSolver::Solve(const std::vector<std::uint32_t>& fixed, PoseGraph& graph) {
  work_.poses += graph.poses.size();
  work_.links += graph.links.size();
  return Optimize(fixed, settings_.optimize, graph);
}

bool GraphSolver::IsStill(const Pose3& before, const Pose3& after) const {
  const Pose3 moved = before.inverse() * after;
  return moved.translation().norm() <= settings_.still &&
         Eigen::AngleAxisd(moved.linear()).angle() <= settings_.still_turn;
}

bool GraphSolver::SolveCoarse(const std::vector<std::uint32_t>& fixed,
                              const std::vector<Link>& closures, PoseGraph& graph) {
  CoarseGraph coarse = MakeCoarse(graph, settings_.coarse);
  for (const Link& closure : closures) {
    const Link between = BetweenGroups(coarse, graph.poses, closure);
    if (between.from != between.to) coarse.graph.links.push_back(between);
  }
  std::vector<std::uint32_t> fixed_groups;
  for (const std::uint32_t pose : fixed) fixed_groups.push_back(coarse.group_of[pose]);
  const std::vector<Pose3> before = coarse.graph.poses;
  is_coarse_due_ = false;
  if (!Solve(fixed_groups, coarse.graph)) return false;
  MoveWithGroups(coarse, before, graph.poses);
  for (std::size_t i = 0; i < is_rough_.size(); ++i) {
    const std::uint32_t group = coarse.group_of[i];
    if (!IsStill(before[group], coarse.graph.poses[group])) is_rough_[i] = true;
  }
  return true;
}

// Those nearest over links, as many as a part may have.
std::vector<std::uint32_t> GraphSolver::PartAround(const std::vector<std::uint32_t>& seeds,
                                                   bool rough_first, const PoseGraph& graph) const {
  std::vector<std::uint32_t> part;
  std::vector<bool> is_in(graph.poses.size());
  std::size_t links = 0;
  const auto meet = [&](std::uint32_t pose, bool only_rough) {
    if (is_in[pose] || (only_rough && !is_rough_[pose])) return;
    const bool is_too_much = part.size() >= settings_.part_poses ||
                             links + links_of_[pose].size() > settings_.part_links;
    if (is_too_much && !part.empty()) return;
    is_in[pose] = true;
    links += links_of_[pose].size();
    part.push_back(pose);
  };
  for (const std::uint32_t seed : seeds) meet(seed, false);
  for (const bool only_rough : {true, false}) {
    if (only_rough && !rough_first) continue;
    for (std::size_t next = 0; next < part.size(); ++next) {
      for (const std::uint32_t index : links_of_[part[next]]) {
        meet(graph.links[index].from, only_rough);
        meet(graph.links[index].to, only_rough);
      }
    }
  }
  return part;
}

bool GraphSolver::SolvePart(const std::vector<std::uint32_t>& part,
                            const std::vector<std::uint32_t>& fixed, PoseGraph& graph) {
  PoseGraph small;
  std::vector<std::uint32_t> held;
  std::unordered_map<std::uint32_t, std::uint32_t> at;  // of poses of the graph in the small one
  for (const std::uint32_t pose : part) {
    at.emplace(pose, static_cast<std::uint32_t>(small.poses.size()));
    if (std::binary_search(fixed.begin(), fixed.end(), pose)) held.push_back(at[pose]);
    small.poses.push_back(graph.poses[pose]);
    small.uprights.push_back(pose < graph.uprights.size() ? graph.uprights[pose] : Upright{});
  }
  const auto find = [&](std::uint32_t pose) {
    const auto [where, is_new] = at.emplace(pose, static_cast<std::uint32_t>(small.poses.size()));
    if (is_new) {
      held.push_back(where->second);
      small.poses.push_back(graph.poses[pose]);
    }
    return where->second;
  };
  for (std::uint32_t i = 0; i < part.size(); ++i) {
    for (const std::uint32_t index : links_of_[part[i]]) {
      Link link = graph.links[index];
      const std::uint32_t other = link.from == part[i] ? link.to : link.from;
      const std::uint32_t there = find(other);
      // A link inside of the part is met at both ends.
      if (there < part.size() && there < i) continue;
      link.from = link.from == part[i] ? i : there;
      link.to = link.to == part[i] ? i : there;
      small.links.push_back(link);
    }
  }
  for (const std::uint32_t pose : part) is_rough_[pose] = false;
  if (!Solve(held, small)) return false;
  for (std::uint32_t i = 0; i < part.size(); ++i) {
    const bool is_still = IsStill(graph.poses[part[i]], small.poses[i]);
    graph.poses[part[i]] = small.poses[i];
    if (is_still) continue;
    is_coarse_due_ = true;
    for (const std::uint32_t index : links_of_[part[i]]) {
      const Link& link = graph.links[index];
      const std::uint32_t other = link.from == part[i] ? link.to : link.from;
      if (at[other] >= part.size()) is_rough_[other] = true;
    }
  }
  return true;
}

bool GraphSolver::SolveAround(const std::vector<std::uint32_t>& poses,
                              const std::vector<std::uint32_t>& fixed, PoseGraph& graph) {
  return SolvePart(PartAround(poses, false, graph), fixed, graph);
}

bool GraphSolver::Refine(const std::vector<std::uint32_t>& fixed, PoseGraph& graph) {
  const auto newest = std::find(is_rough_.rbegin(), is_rough_.rend(), true);
  if (newest == is_rough_.rend()) return is_coarse_due_ && SolveCoarse(fixed, {}, graph);
  const auto seed = static_cast<std::uint32_t>(is_rough_.rend() - newest - 1);
  return SolvePart(PartAround({seed}, true, graph), fixed, graph);
}

}  // namespace coppice::robot::slam
