#include "bt_nodes/power/battery_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice {
namespace {

double Seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

std::string Print(const char* format, double a, double b) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

}  // namespace

const BatteryVerdict& BatteryWatch::Update(Time now, const BatteryReading* reading,
                                           double distance) {
  if (!started_) {
    started_ = updated_ = last_charge_ = heard_ = now;
    counted_ = options_.model.capacity;
  }
  if (reading && (!newest_ || reading->stamp != newest_->stamp)) TakeReading(now, *reading);
  const bool is_silent = Seconds(now - heard_) > options_.longest_silence;
  if (is_silent) is_charging_ = false;
  const double assumed = -options_.model.driving_current;
  CountCharge(now, is_silent || !newest_ ? assumed : newest_->current);
  farthest_ = std::max(farthest_, distance);

  verdict_.charge = LeastCharge();
  const double way = ChargeToDrive(options_.model, distance < 0 ? farthest_ : distance);
  verdict_.needed = way + ChargeReserve(options_.model);
  const bool is_charged =
      is_charging_ && verdict_.charge >= options_.charged * options_.model.capacity;
  if (is_charging_ && (is_charged || Seconds(now - charging_since_) >= options_.counts_after)) {
    last_charge_ = now;
  }
  std::string reason = Reason(now);
  if (!reason.empty() && !is_charging_) {
    verdict_.due = true;
    verdict_.reason = std::move(reason);
  } else if (is_charged) {
    verdict_.due = false;
    verdict_.reason.clear();
  }
  verdict_.critical = !is_charging_ && verdict_.charge < options_.critical * verdict_.needed;
  if (is_charging_) {
    verdict_.exhausted = false;
  } else if (!is_silent && IsExhausted(way)) {
    verdict_.exhausted = true;
  }
  return verdict_;
}

bool BatteryWatch::IsExhausted(double way) const {
  return newest_ && ReadCharge() <= std::max(way, options_.last_charge);
}

void BatteryWatch::TakeReading(Time now, const BatteryReading& reading) {
  const double level = LevelFromVoltage(options_.model, reading.voltage, reading.current);
  if (!newest_) {
    voltage_level_ = level;
    counted_ = (reading.level >= 0 ? reading.level : level) * options_.model.capacity;
  } else {
    const double share = 1 - std::exp(-Seconds(now - heard_) / options_.smoothing);
    voltage_level_ += share * (level - voltage_level_);
  }
  const bool was_charging = is_charging_;
  is_charging_ = reading.current > options_.model.charging_above;
  if (is_charging_ && !was_charging) charging_since_ = now;
  newest_ = reading;
  heard_ = now;
}

void BatteryWatch::CountCharge(Time now, double current) {
  counted_ += current * Seconds(now - updated_) / 3600;
  // What was counted too much, as while the battery was silent, is forgotten on the station.
  if (is_charging_) counted_ = std::max(counted_, ReadCharge());
  counted_ = std::clamp(counted_, 0.0, options_.model.capacity);
  updated_ = now;
}

double BatteryWatch::ReadCharge() const {
  double level = voltage_level_;
  if (newest_->level >= 0) level = std::min(level, newest_->level);
  return level * options_.model.capacity;
}

double BatteryWatch::LeastCharge() const {
  return newest_ ? std::min(counted_, ReadCharge()) : counted_;
}

std::string BatteryWatch::Reason(Time now) const {
  if (verdict_.charge <= verdict_.needed) {
    return Print("%.1f Ah are left, %.1f Ah are needed for the way to the station and the reserve",
                 verdict_.charge, verdict_.needed);
  }
  const double silent = Seconds(now - heard_);
  if (silent > options_.longest_silence) {
    return Print("the battery has been silent for %.0f s, longer than %.0f s", silent,
                 options_.longest_silence);
  }
  const double without = Seconds(now - last_charge_);
  if (without > options_.longest_without_charge) {
    return Print("the last charge was %.1f h ago, longer than %.1f h", without / 3600,
                 options_.longest_without_charge / 3600);
  }
  return {};
}

}  // namespace coppice
