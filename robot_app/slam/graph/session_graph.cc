#include "robot_app/slam/graph/session_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace coppice::robot::slam {
namespace {

constexpr std::size_t kMostWaiting = 200;  // closures; the oldest are forgotten

double AngleOf(const Pose3& pose) { return Eigen::AngleAxisd(pose.linear()).angle(); }

}  // namespace

SessionGraph::SessionGraph(SessionGraphSettings settings, PoseGraph graph,
                           std::vector<std::uint32_t> sessions)
    : settings_(settings), graph_(std::move(graph)), sessions_(std::move(sessions)) {
  maps_.resize(sessions_.empty() ? 0 : sessions_.back() + 1);
  std::iota(maps_.begin(), maps_.end(), 0U);
  for (const Link& link : graph_.links) {
    const std::uint32_t a = maps_[sessions_[link.from]];
    const std::uint32_t b = maps_[sessions_[link.to]];
    if (a != b) std::replace(maps_.begin(), maps_.end(), std::max(a, b), std::min(a, b));
  }
}

std::uint32_t SessionGraph::AddPose(const Pose3& moved, const Matrix6& information) {
  const auto index = static_cast<std::uint32_t>(graph_.poses.size());
  if (std::exchange(begins_, false)) {
    maps_.push_back(session_count());
    graph_.poses.push_back(Pose3::Identity());
  } else {
    graph_.links.push_back({index - 1, index, moved, information, LinkKind::kStep});
    graph_.poses.push_back(graph_.poses.back() * moved);
  }
  sessions_.push_back(session_count() - 1);
  return index;
}

bool SessionGraph::InOneMap(std::uint32_t pose, std::uint32_t other) const {
  return maps_[sessions_[pose]] == maps_[sessions_[other]];
}

Verdict SessionGraph::AddClosure(const Link& closure) {
  return InOneMap(closure.from, closure.to) ? CloseInside({closure}) : Join(closure);
}

// The first pose of each map stays.
std::vector<std::uint32_t> SessionGraph::FirstPoses() const {
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < sessions_.size(); ++i) {
    const bool begins = i == 0 || sessions_[i] != sessions_[i - 1];
    if (begins && maps_[sessions_[i]] == sessions_[i]) first.push_back(i);
  }
  return first;
}

Verdict SessionGraph::CloseInside(const std::vector<Link>& closures) {
  if (std::all_of(closures.begin(), closures.end(), [this](const Link& link) {
        return SquaredError(link, graph_.poses) <= settings_.settled;
      })) {
    graph_.links.insert(graph_.links.end(), closures.begin(), closures.end());
    return Verdict::kBelieved;
  }
  std::vector<Pose3> before = graph_.poses;
  const auto fits = [this](const Link& link) {
    return SquaredError(link, graph_.poses) <= settings_.most_error;
  };
  std::vector<std::size_t> fitted;  // closures that must go on fitting
  for (std::size_t i = 0; i < graph_.links.size(); ++i) {
    if (graph_.links[i].is_closure() && fits(graph_.links[i])) fitted.push_back(i);
  }
  graph_.links.insert(graph_.links.end(), closures.begin(), closures.end());
  if (Optimize(FirstPoses(), settings_.optimize, graph_) &&
      std::all_of(closures.begin(), closures.end(), fits) &&
      std::all_of(fitted.begin(), fitted.end(),
                  [&](std::size_t i) { return fits(graph_.links[i]); })) {
    return Verdict::kBelieved;
  }
  graph_.links.resize(graph_.links.size() - closures.size());
  graph_.poses = std::move(before);
  return Verdict::kRefused;
}

// Both say where the frame of one map lies in that of the other.
bool SessionGraph::SaysTheSame(const Link& closure, const Link& other) const {
  const auto map_of = [this](std::uint32_t pose) { return maps_[sessions_[pose]]; };
  Link turned = other;
  if (map_of(turned.from) != map_of(closure.from)) {
    std::swap(turned.from, turned.to);
    turned.relative = other.relative.inverse();
  }
  if (map_of(turned.from) != map_of(closure.from) || map_of(turned.to) != map_of(closure.to)) {
    return false;
  }
  const auto& poses = graph_.poses;
  const auto way = [&](std::uint32_t a, std::uint32_t b) {
    return (poses[a].translation() - poses[b].translation()).norm();
  };
  if (way(closure.from, turned.from) < settings_.apart ||
      way(closure.to, turned.to) < settings_.apart) {
    return false;
  }
  // What the other says of pose closure.to, as seen from what this one says of it.
  const Pose3 by_other =
      poses[turned.from] * turned.relative * poses[turned.to].inverse() * poses[closure.to];
  const Pose3 off = (poses[closure.from] * closure.relative).inverse() * by_other;
  return off.translation().norm() <= settings_.most_off && AngleOf(off) <= settings_.most_turned;
}

Verdict SessionGraph::Join(const Link& closure) {
  const auto same = std::find_if(waiting_.begin(), waiting_.end(),
                                 [&](const Link& other) { return SaysTheSame(closure, other); });
  if (same == waiting_.end()) {
    if (waiting_.size() >= kMostWaiting) waiting_.erase(waiting_.begin());
    waiting_.push_back(closure);
    return Verdict::kWaits;
  }
  const std::vector<Link> both{*same, closure};
  std::vector<Pose3> before = graph_.poses;
  std::vector<std::uint32_t> maps = maps_;
  const Pose3 motion = graph_.poses[closure.from] * closure.relative *
                       graph_.poses[closure.to].inverse();  // of the map of closure.to
  const std::uint32_t from = maps_[sessions_[closure.from]];
  const std::uint32_t to = maps_[sessions_[closure.to]];
  if (from < to) {
    MoveMap(to, from, motion);
  } else {
    MoveMap(from, to, motion.inverse());
  }
  if (CloseInside(both) == Verdict::kRefused) {
    graph_.poses = std::move(before);
    maps_ = std::move(maps);
    return Verdict::kRefused;
  }
  // Others that waited between these two were not believed; what they saw will be seen again.
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                [this](const Link& link) { return InOneMap(link.from, link.to); }),
                 waiting_.end());
  return Verdict::kBelieved;
}

void SessionGraph::MoveMap(std::uint32_t from, std::uint32_t to, const Pose3& motion) {
  for (std::size_t i = 0; i < graph_.poses.size(); ++i) {
    if (maps_[sessions_[i]] == from) graph_.poses[i] = motion * graph_.poses[i];
  }
  std::replace(maps_.begin(), maps_.end(), from, to);
}

}  // namespace coppice::robot::slam
