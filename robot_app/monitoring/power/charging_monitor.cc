#include "robot_app/monitoring/power/charging_monitor.h"

#include <cmath>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

using leaves::HealthLevel;

void ChargingMonitor::OnReading(const leaves::BatteryReading& reading, Time now) {
  if (!watch_) return;
  if (reading_ && now < heard_at_) missing_since_.reset();  // time jumped back
  reading_ = reading;
  heard_at_ = now;
  const bool has_contact = leaves::StandsOnStation(reading, watch_->current).value_or(false);
  const bool is_full =
      reading.charger == leaves::ChargerState::kFull || reading.level >= watch_->full;
  const bool flows = std::isnan(reading.current)
                         ? reading.charger == leaves::ChargerState::kCharging
                         : reading.current >= watch_->current;
  const bool needs_none = !has_contact || is_full;
  if (flows || needs_none) missing_since_.reset();
  if (!flows && !needs_none && !missing_since_) missing_since_ = now;
  has_flowed_ = has_contact && (has_flowed_ || flows);
}

std::vector<Finding> ChargingMonitor::Report(const ProcessTable&, const Times& now) {
  if (!watch_) return {};
  Finding finding{"charging", "current", "", HealthLevel::kOk, 0, "A", "", now.ros};
  if (!reading_) {
    finding.message = "state unknown";
    return {finding};
  }
  finding.value = reading_->current;
  if (!missing_since_) return {finding};
  // By the last reading: what came after it is not known, and a silent battery is an error itself.
  const Duration missing = heard_at_ - *missing_since_;
  const bool is_late = missing > (has_flowed_ ? watch_->interruption : watch_->within);
  finding.level = is_late ? HealthLevel::kError : HealthLevel::kWarn;
  finding.message =
      (has_flowed_ ? "the charging current stopped " : "contact without current for ") +
      SecondsText(missing) + (has_flowed_ ? " ago" : "");
  return {finding};
}

}  // namespace coppice::robot::monitoring
