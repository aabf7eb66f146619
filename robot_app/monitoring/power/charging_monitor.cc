#include "robot_app/monitoring/power/charging_monitor.h"

namespace coppice::robot {

void ChargingMonitor::OnSample(const BatterySample& sample, Time now) {
  if (!watch_) return;
  if (sample_ && now < heard_at_) missing_since_.reset();  // time jumped back
  sample_ = sample;
  heard_at_ = now;
  const bool flows = sample.current >= watch_->current;
  const bool needs_none = !sample.on_charger || sample.is_full || sample.level >= watch_->full;
  if (flows || needs_none) missing_since_.reset();
  if (!flows && !needs_none && !missing_since_) missing_since_ = now;
  has_flowed_ = sample.on_charger && (has_flowed_ || flows);
}

std::vector<Finding> ChargingMonitor::Report(Time now) const {
  if (!watch_) return {};
  Finding finding{"charging", "current", "", HealthLevel::kOk, 0, "A", "", now};
  if (!sample_) {
    finding.message = "state unknown";
    return {finding};
  }
  finding.value = sample_->current;
  if (!missing_since_) return {finding};
  // By the last sample: what came after it is not known, and a silent battery is an error itself.
  const Duration missing = heard_at_ - *missing_since_;
  const bool is_late = missing > (has_flowed_ ? watch_->interruption : watch_->within);
  finding.level = is_late ? HealthLevel::kError : HealthLevel::kWarn;
  finding.message =
      (has_flowed_ ? "the charging current stopped " : "contact without current for ") +
      ToText(std::chrono::duration<double>(missing).count()) + (has_flowed_ ? " s ago" : " s");
  return {finding};
}

}  // namespace coppice::robot
