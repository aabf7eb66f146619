#include "bt_nodes/power/power_leaves.h"

#include <algorithm>

namespace coppice::leaves {
namespace {

constexpr double kLow = 0.3;       // without a plan
constexpr double kCharged = 0.95;  // beyond that it takes long

}  // namespace

Status PlanCharge::Run() {
  double low_level = kLow, charged = kCharged;
  if (duty_left.has_value() && *duty_left > 0) {
    const double rest = *duty_left / 3600 * *current / *capacity;
    low_level = std::clamp(*reserve + rest - *slack, *reserve, std::max(*reserve, *low));
    charged = std::min(charged, *reserve + rest);
    if (requested.has_value() && *requested) charged = std::max(charged, *when_requested);
  }
  low_below.Set(low_level);
  until.Set(std::max(charged, std::min(kCharged, low_level + 0.01)));
  return Status::kSuccess;
}

bool ChargeDue::Check() {
  if (!watch_) {
    BatteryWatchOptions options;
    options.model.capacity = *capacity;
    options.model.full_voltage = *full_voltage;
    options.model.empty_voltage = *empty_voltage;
    options.model.driving_current = *driving_current;
    options.model.driving_speed = *driving_speed;
    options.longest_without_charge = *longest_without_charge;
    options.longest_silence = *longest_silence;
    options.last_charge = *last_charge;
    options.charged = *charged;
    watch_ = std::make_unique<BatteryWatch>(options);
    critical.Set(false);
    exhausted.Set(false);
  }
  const BatteryVerdict& verdict = watch_->Update(now(), battery.has_value() ? &*battery : nullptr,
                                                 distance.has_value() ? *distance : -1);
  if (verdict.critical != told_.critical) critical.Set(verdict.critical);
  if (verdict.exhausted != told_.exhausted) exhausted.Set(verdict.exhausted);
  const bool is_new = verdict.due && !told_.due;
  told_.critical = verdict.critical;
  told_.exhausted = verdict.exhausted;
  told_.due = verdict.due;
  if (is_new) {
    reason.Set(verdict.reason);
    Say(verdict.reason);
  }
  return verdict.due;
}

}  // namespace coppice::leaves
