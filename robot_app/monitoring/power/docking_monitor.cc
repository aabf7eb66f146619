#include "robot_app/monitoring/power/docking_monitor.h"

#include <algorithm>
#include <utility>

namespace coppice::robot::monitoring {
namespace {

constexpr char kMonitor[] = "docking";

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
    freshness_.Reset();
  }
  watch_ = watch;
  std::vector<GaugeWatch> gauges;
  if (watch) {
    gauges = {{kMonitor, "failures", "", "", watch->failures},
              {kMonitor, "duration", "", "s", watch->duration}};
  }
  board_.Watch(gauges);
}

void DockingMonitor::OnGoals(const std::vector<GoalReport>& goals, const Times& now) {
  if (!watch_) return;
  freshness_.OnMessage(now);
  std::map<std::string, Goal> known;
  for (const GoalReport& report : goals) {
    const auto before = goals_.find(report.id);
    Goal goal = before == goals_.end() ? Goal{GoalPhase::kPending, now.ros} : before->second;
    if (IsOver(report.phase) && !IsOver(goal.phase)) End(report, goal, now.ros);
    if (IsUnderWay(report.phase) && !IsUnderWay(goal.phase)) goal.begun = now.ros;
    goal.phase = report.phase;
    known[report.id] = goal;
  }
  goals_ = std::move(known);
}

// Status and feedback come by different ways: either may be first to tell.
void DockingMonitor::OnProgress(const std::string& id, int failed, const std::string& why,
                                Time now) {
  if (!watch_) return;
  Goal& goal = goals_.insert({id, Goal{GoalPhase::kPending, now}}).first->second;
  if (IsOver(goal.phase)) return;
  goal.is_tried = true;
  if (failed <= goal.failed) return;
  failures_ += failed - goal.failed;
  goal.failed = failed;
  reason_ = why;
  failed_at_ = now;
}

// A goal that failed without a failed attempt counts as one.
void DockingMonitor::End(const GoalReport& report, const Goal& goal, Time now) {
  const bool failed = (report.phase == GoalPhase::kAborted && goal.is_tried) ||
                      report.phase == GoalPhase::kRejected;
  if (report.phase == GoalPhase::kSucceeded) failures_ = 0;
  if (!failed) return;
  if (goal.failed == 0) ++failures_;
  reason_ = report.message;
  failed_at_ = now;
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
  if (processes.IsStarting(watch_->node)) freshness_.Reset();
  if (now.ros - failed_at_ > watch_->forget || now.ros < failed_at_) failures_ = 0;

  Finding state = freshness_.Assess({kMonitor, "state", watch_->node}, watch_->staleness,
                                    watch_->action + ": no status", processes, now);
  board_.OnValue(kMonitor, "failures", failures_, now.ros);
  board_.OnValue(kMonitor, "duration", Longest(now.ros), now.ros);
  std::vector<Finding> findings = board_.Report(now.ros, now.ros);
  if (findings[0].level != leaves::HealthLevel::kOk) {
    findings[0].message = std::to_string(failures_) + " in a row: " + reason_;
  }
  findings.insert(findings.begin(), std::move(state));
  return findings;
}

}  // namespace coppice::robot::monitoring
