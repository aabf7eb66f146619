#include "bt_nodes/power/battery_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice::leaves {
namespace {

// State of charge at which the shortest charge settles a request.
constexpr double kNearlyFull = 0.9;

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
  CountCharge(now, Current(is_silent));
  farthest_ = std::max(farthest_, distance);

  verdict_.charge = LeastCharge();
  const double way = ChargeToDrive(options_.model, distance < 0 ? farthest_ : distance);
  verdict_.needed = way + ChargeReserve(options_.model);
  const bool is_full = is_charging_ && newest_->charger == ChargerState::kFull;
  const bool counts = is_charging_ && Seconds(now - charging_since_) >= options_.counts_after;
  const double enough = counts ? options_.charged : std::max(options_.charged, kNearlyFull);
  const bool is_charged =
      is_full || (is_charging_ && verdict_.charge >= enough * options_.model.capacity);
  if (is_charged || counts) last_charge_ = now;
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
  const std::optional<double> charge = ReadCharge();
  return charge && *charge <= std::max(way, options_.last_charge);
}

void BatteryWatch::TakeReading(Time now, const BatteryReading& reading) {
  const bool was_charging = is_charging_;
  is_charging_ = reading.charger == ChargerState::kFull ||
                 reading.current > options_.model.charging_above ||
                 (std::isnan(reading.current) && reading.charger == ChargerState::kCharging);
  if (is_charging_ && !was_charging) charging_since_ = now;
  newest_ = reading;
  if (!std::isnan(reading.level) || !std::isnan(reading.voltage)) TakeLevels(now, reading);
}

void BatteryWatch::TakeLevels(Time now, const BatteryReading& reading) {
  const bool is_first = !ReadCharge();
  level_ = std::isnan(reading.level) ? std::nullopt : std::optional(reading.level);
  if (std::isnan(reading.voltage)) {
    voltage_level_.reset();
  } else {
    const double current = std::isnan(reading.current) ? 0 : reading.current;
    const double level = LevelFromVoltage(options_.model, reading.voltage, current);
    const double share = 1 - std::exp(-Seconds(now - heard_) / options_.smoothing);
    const double before = voltage_level_.value_or(level);
    voltage_level_ = before + share * (level - before);
  }
  if (is_first) counted_ = level_.value_or(voltage_level_.value_or(0)) * options_.model.capacity;
  heard_ = now;
}

double BatteryWatch::Current(bool is_silent) const {
  if (!is_silent && newest_ && !std::isnan(newest_->current)) return newest_->current;
  return is_charging_ ? 0 : -options_.model.driving_current;
}

void BatteryWatch::CountCharge(Time now, double current) {
  counted_ += current * Seconds(now - updated_) / 3600;
  // What was counted too much, as while the battery was silent, is forgotten on the station.
  if (is_charging_) counted_ = std::max(counted_, ReadCharge().value_or(0));
  counted_ = std::clamp(counted_, 0.0, options_.model.capacity);
  updated_ = now;
}

std::optional<double> BatteryWatch::ReadCharge() const {
  if (!level_ && !voltage_level_) return std::nullopt;
  return std::min(level_.value_or(1), voltage_level_.value_or(1)) * options_.model.capacity;
}

double BatteryWatch::LeastCharge() const {
  return std::min(counted_, ReadCharge().value_or(counted_));
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

}  // namespace coppice::leaves
