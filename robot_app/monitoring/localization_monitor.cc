#include "robot_app/monitoring/localization_monitor.h"

#include <utility>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

constexpr char kMonitor[] = "localization";

}  // namespace

void LocalizationMonitor::Watch(const std::optional<LocalizationWatch>& watch) {
  if (!watch_ || !watch || watch_->topic != watch->topic) {
    state_.reset();
    freshness_.Reset();
  }
  watch_ = watch;
  std::vector<GaugeWatch> gauges;
  if (watch) {
    gauges = {{kMonitor, "since_confirmed", watch->node, "s", watch->since_confirmed},
              {kMonitor, "score", watch->node, "", watch->score},
              {kMonitor, "deviation", watch->node, "m", watch->deviation}};
  }
  board_.Watch(gauges);
}

void LocalizationMonitor::OnState(LocalizationReading state, const Times& now) {
  if (!watch_) return;
  board_.OnValue(kMonitor, "since_confirmed", state.since_confirmed, now.ros);
  board_.OnValue(kMonitor, "score", state.score, now.ros);
  board_.OnValue(kMonitor, "deviation", state.deviation, now.ros);
  state_ = std::move(state);
  freshness_.OnMessage(now);
}

std::vector<Finding> LocalizationMonitor::Report(const ProcessTable& processes, const Times& now) {
  if (!watch_) return {};
  if (processes.IsStarting(watch_->node)) {
    state_.reset();
    freshness_.Reset();
  }
  const bool is_fresh = state_ && freshness_.Lasted(now) <= watch_->staleness;
  if (!is_fresh) board_.Reset();
  std::vector<Finding> findings = {Phase(now.ros, is_fresh)};
  for (Finding& number : board_.Report(now.ros, now.ros)) findings.push_back(std::move(number));
  findings.push_back(freshness_.Assess({"topic", watch_->topic, watch_->node}, watch_->staleness,
                                       "no state", processes, now));
  return findings;
}

Finding LocalizationMonitor::Phase(Time now, bool is_fresh) const {
  Finding finding{kMonitor, "phase", watch_->node, HealthLevel::kOk, 0, "", "", now, ""};
  if (!is_fresh) {
    finding.message = "state unknown";
    return finding;
  }
  finding.value = static_cast<double>(state_->phase);
  if (state_->phase == LocalizationReading::Phase::kOk) return finding;
  const bool is_lost = state_->phase != LocalizationReading::Phase::kUncertain;
  finding.level = is_lost ? HealthLevel::kError : HealthLevel::kWarn;
  finding.message = is_lost ? "lost" : "uncertain";
  if (!state_->message.empty()) finding.message += ": " + state_->message;
  return finding;
}

}  // namespace coppice::robot::monitoring
