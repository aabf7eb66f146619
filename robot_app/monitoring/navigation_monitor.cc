#include "robot_app/monitoring/navigation_monitor.h"

#include <algorithm>
#include <utility>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

using leaves::HealthLevel;

void NavigationMonitor::Watch(const std::optional<NavigationWatch>& watch) {
  if (!watch_ || !watch || watch_->topic != watch->topic) {
    state_.reset();
    freshness_.Reset();
  }
  watch_ = watch;
}

void NavigationMonitor::OnState(NavigationReport state, const Times& now) {
  if (!watch_) return;
  if (state.phase == NavigationPhase::kDriving) has_driven_ = true;
  if (state.phase == NavigationPhase::kIdle) has_driven_ = false;
  state_ = std::move(state);
  heard_at_ = now.ros;
  freshness_.OnMessage(now);
}

std::vector<Finding> NavigationMonitor::Report(const ProcessTable& processes, const Times& now) {
  if (!watch_) return {};
  if (processes.IsStarting(watch_->node)) {
    state_.reset();
    freshness_.Reset();
  }
  // An old state says nothing about now; that it is old is the other finding.
  const bool is_fresh = state_ && freshness_.Lasted(now) <= watch_->staleness;
  return {Progress(now.ros, is_fresh),
          freshness_.Assess({"topic", watch_->topic, watch_->node}, watch_->staleness, "no state",
                            processes, now)};
}

Finding NavigationMonitor::Progress(Time now, bool is_fresh) const {
  Finding finding{"navigation", "progress", "", HealthLevel::kOk, 0, "s", "", now};
  if (!is_fresh) {
    finding.message = "state unknown";
    return finding;
  }
  const Duration lasted = state_->in_phase + std::max(Duration::zero(), now - heard_at_);
  // Between two attempts of the application the server is idle, but the fault is still there.
  const bool idle = state_->phase == NavigationPhase::kIdle;
  if (idle && state_->consecutive_failures > 0 && lasted < watch_->after_failure) {
    finding.level = HealthLevel::kError;
    finding.message = "the last goal was not reached: " + state_->message;
    return finding;
  }
  const bool no_path = state_->phase == NavigationPhase::kNoPath;
  if (!no_path && state_->phase != NavigationPhase::kBlocked) return finding;

  const Duration bound = no_path ? watch_->no_path : watch_->blocked;
  // Who is held up before the next attempt has got anywhere has not recovered.
  const bool failed = state_->consecutive_failures > 0 && (no_path || !has_driven_);
  finding.level = failed || lasted > bound ? HealthLevel::kError : HealthLevel::kWarn;
  finding.value = InSeconds(lasted);
  finding.message = (no_path ? "no path for " : "blocked for ") + SecondsText(lasted);
  if (!state_->message.empty()) finding.message += ": " + state_->message;
  return finding;
}

}  // namespace coppice::robot::monitoring
