#include "robot_app/monitoring/power/docking_monitor.h"

#include <algorithm>
#include <utility>

namespace coppice::robot {
namespace {

constexpr char kMonitor[] = "docking";

double InSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

bool IsUnderWay(GoalPhase phase) {
  return phase == GoalPhase::kActive || phase == GoalPhase::kPreempting;
}

bool IsOver(GoalPhase phase) {
  return phase != GoalPhase::kPending && phase != GoalPhase::kRecalling && !IsUnderWay(phase);
}

}  // namespace

void DockingMonitor::Watch(const std::optional<DockingWatch>& watch) {
  if (!watch || !watch_ || watch->action != watch_->action) {
    goals_.clear();
    failures_ = 0;
    heard_at_.reset();
  }
  watch_ = watch;
  std::vector<GaugeWatch> gauges;
  if (watch) {
    gauges = {{kMonitor, "failures", "", "", watch->failures},
              {kMonitor, "duration", "", "s", watch->duration}};
  }
  board_.Watch(gauges);
}

void DockingMonitor::OnGoals(const std::vector<GoalReport>& goals, Time now) {
  if (!watch_) return;
  heard_at_ = now;
  std::map<std::string, Goal> known;
  for (const GoalReport& report : goals) {
    const auto before = goals_.find(report.id);
    Goal goal = before == goals_.end() ? Goal{GoalPhase::kPending, now} : before->second;
    if (IsOver(report.phase) && !IsOver(goal.phase)) End(report, now);
    if (IsUnderWay(report.phase) && !IsUnderWay(goal.phase)) goal.begun = now;
    goal.phase = report.phase;
    known[report.id] = goal;
  }
  goals_ = std::move(known);
}

void DockingMonitor::End(const GoalReport& goal, Time now) {
  const bool failed = goal.phase == GoalPhase::kAborted || goal.phase == GoalPhase::kRejected;
  if (goal.phase == GoalPhase::kSucceeded) failures_ = 0;
  if (!failed) return;
  ++failures_;
  reason_ = goal.message;
  ended_at_ = now;
}

double DockingMonitor::Longest(Time now) const {
  double longest = 0;
  for (const auto& [id, goal] : goals_) {
    if (IsUnderWay(goal.phase)) longest = std::max(longest, InSeconds(now - goal.begun));
  }
  return longest;
}

std::vector<Finding> DockingMonitor::Report(const ProcessTable& processes, const Times& now) {
  if (!watch_) return {};
  if (processes.IsStarting(watch_->node)) heard_at_.reset();
  if (!heard_at_ || now.ros < *heard_at_) heard_at_ = now.ros;
  if (now.ros - ended_at_ > watch_->forget || now.ros < ended_at_) failures_ = 0;

  Finding state{kMonitor, "state", watch_->node, HealthLevel::kOk, 0, "s", "", now.ros};
  state.value = InSeconds(now.ros - *heard_at_);
  if (now.ros - *heard_at_ > watch_->staleness) {
    state.level = HealthLevel::kError;
    state.message = watch_->action + ": no status for " + ToText(state.value) + " s";
  }
  freshness_.Apply(state, now.wall, patience_);
  ApplyGrace(processes, watch_->node, state);

  board_.OnValue(kMonitor, "failures", failures_, now.ros);
  board_.OnValue(kMonitor, "duration", Longest(now.ros), now.ros);
  std::vector<Finding> findings = board_.Report(now.ros, now.ros);
  if (findings[0].level != HealthLevel::kOk) {
    findings[0].message = std::to_string(failures_) + " in a row: " + reason_;
  }
  findings.insert(findings.begin(), std::move(state));
  return findings;
}

}  // namespace coppice::robot
