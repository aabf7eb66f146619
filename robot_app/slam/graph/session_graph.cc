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
    : settings_(settings), solver_(settings.solver), sessions_(std::move(sessions)) {
  std::vector<const Link*> steps(graph.poses.size());  // to each pose
  for (const Link& link : graph.links) {
    if (!link.is_closure()) steps[link.to] = &link;
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] == nullptr) {
      AddFirst(graph.poses[i]);
    } else {
      AddNext(graph.poses[i], steps[i]->relative);
    }
  }
  for (const Link& link : graph.links) {
    graph_.links.push_back(link);
    solver_.AddLink(graph_);
  }
  solver_.SetRough(std::vector<bool>(graph_.poses.size(), true));  // perhaps it was written so
  maps_.resize(sessions_.empty() ? 0 : sessions_.back() + 1);
  std::iota(maps_.begin(), maps_.end(), 0U);
  for (const Link& link : graph_.links) {
    const std::uint32_t a = maps_[sessions_[link.from]];
    const std::uint32_t b = maps_[sessions_[link.to]];
    if (a != b) std::replace(maps_.begin(), maps_.end(), std::max(a, b), std::min(a, b));
  }
}

void SessionGraph::AddFirst(const Pose3& pose) {
  odometry_ = Eigen::Matrix3d::Identity();
  AddPose(pose);
}

void SessionGraph::AddNext(const Pose3& pose, const Pose3& moved) {
  odometry_ = odometry_ * moved.linear();
  AddPose(pose);
}

void SessionGraph::AddPose(const Pose3& pose) {
  graph_.poses.push_back(pose);
  const Eigen::Vector3d up = odometry_.transpose() * Eigen::Vector3d::UnitZ();
  graph_.uprights.push_back({up.head<2>(), 1 / (settings_.tilt * settings_.tilt)});
  solver_.AddPose();
}

std::uint32_t SessionGraph::AddPose(const Pose3& moved, const Matrix6& information) {
  const auto index = static_cast<std::uint32_t>(graph_.poses.size());
  const bool begun = std::exchange(begins_, false);
  if (begun) {
    maps_.push_back(session_count());
    AddFirst(Pose3::Identity());
  } else {
    graph_.links.push_back({index - 1, index, moved, information, LinkKind::kStep});
    AddNext(graph_.poses.back() * moved, moved);
    solver_.AddLink(graph_);
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

bool SessionGraph::AllFit(const std::vector<Link>& closures, double most) const {
  return std::all_of(closures.begin(), closures.end(),
                     [&](const Link& link) { return SquaredError(link, graph_.poses) <= most; });
}

Verdict SessionGraph::CloseInside(const std::vector<Link>& closures) {
  const auto add = [&] {
    for (const Link& closure : closures) {
      graph_.links.push_back(closure);
      solver_.AddLink(graph_);
    }
  };
  if (AllFit(closures, settings_.settled)) return add(), Verdict::kBelieved;
  std::vector<Pose3> before = graph_.poses;
  std::vector<bool> rough = solver_.rough();
  std::vector<Link> fitted;  // closures that must go on fitting
  for (const Link& link : graph_.links) {
    if (link.is_closure() && SquaredError(link, graph_.poses) <= settings_.most_error) {
      fitted.push_back(link);
    }
  }
  const bool is_far = !AllFit(closures, settings_.most_error);
  const std::size_t links = graph_.links.size();
  if (!is_far || solver_.SolveCoarse(FirstPoses(), closures, graph_)) {
    add();
    if (SolveAround(closures) && AllFit(closures, settings_.most_error) &&
        AllFit(fitted, settings_.most_error * (is_far ? settings_.while_rough : 1))) {
      return Verdict::kBelieved;
    }
  }
  for (; graph_.links.size() > links; graph_.links.pop_back()) solver_.DropLink(graph_);
  graph_.poses = std::move(before);
  solver_.SetRough(std::move(rough));
  return Verdict::kRefused;
}

bool SessionGraph::SolveAround(const std::vector<Link>& closures) {
  std::vector<std::uint32_t> ends;
  for (const Link& closure : closures) ends.insert(ends.end(), {closure.from, closure.to});
  return solver_.SolveAround(ends, FirstPoses(), graph_);
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
