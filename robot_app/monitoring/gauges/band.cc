#include "robot_app/monitoring/gauges/band.h"

#include <cstdio>
#include <utility>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

Range Shrink(Range range, double by) {
  if (range.low) *range.low += by;
  if (range.high) *range.high -= by;
  return range;
}

std::string WithUnit(double number, const std::string& unit) {
  return unit.empty() ? ToText(number) : ToText(number) + " " + unit;
}

}  // namespace

bool Range::Contains(double value) const {
  return !(low && !(value >= *low)) && !(high && !(value <= *high));
}

bool HasBounds(const Band& band) { return !(band.warn == Range()) || !(band.error == Range()); }

Band AtMost(double warn, double error, int consecutive) {
  return {{std::nullopt, warn}, {std::nullopt, error}, consecutive, Duration::zero(), 0};
}

Band AtLeast(double warn, double error, int consecutive, double hysteresis) {
  return {{warn, std::nullopt}, {error, std::nullopt}, consecutive, Duration::zero(), hysteresis};
}

Judge::Judge(Band band, std::string unit) : band_(std::move(band)), unit_(std::move(unit)) {}

void Judge::OnValue(double value, Time now) {
  value_ = value;
  failure_.clear();
  heard_at_ = now;
  const double to_leave_error = level_ >= HealthLevel::kError ? band_.hysteresis : 0;
  const double to_leave_warn = level_ >= HealthLevel::kWarn ? band_.hysteresis : 0;
  if (!Shrink(band_.error, to_leave_error).Contains(value)) return Count(HealthLevel::kError);
  const bool is_well = Shrink(band_.warn, to_leave_warn).Contains(value);
  Count(is_well ? HealthLevel::kOk : HealthLevel::kWarn);
}

void Judge::OnFailure(const std::string& why, Time now) {
  failure_ = why;
  heard_at_ = now;
  Count(HealthLevel::kError);
}

void Judge::Count(HealthLevel level) {
  errors_ = level >= HealthLevel::kError ? errors_ + 1 : 0;
  warnings_ = level >= HealthLevel::kWarn ? warnings_ + 1 : 0;
  level_ = errors_ >= band_.consecutive                    ? HealthLevel::kError
           : errors_ > 0 || warnings_ >= band_.consecutive ? HealthLevel::kWarn
                                                           : HealthLevel::kOk;
}

Assessment Judge::Assess(Time now) {
  if (!heard_at_ || now < *heard_at_) heard_at_ = now;
  const Duration silence = now - *heard_at_;
  if (band_.staleness > Duration::zero() && silence > band_.staleness) {
    const double seconds = std::chrono::duration<double>(silence).count();
    return {HealthLevel::kError, "no value for " + ToText(seconds) + " s"};
  }
  if (!failure_.empty()) return {level_, failure_};
  if (!value_) return {HealthLevel::kOk, "no value yet"};
  if (level_ == HealthLevel::kOk) return {};
  const Range& expected = errors_ > 0 ? band_.error : band_.warn;
  return {level_, WithUnit(*value_, unit_) + ", expected " + ToText(expected, unit_)};
}

void Judge::Reset() { *this = Judge(band_, unit_); }

std::string ToText(const Range& range, const std::string& unit) {
  if (range.low && range.high) return ToText(*range.low) + " to " + WithUnit(*range.high, unit);
  if (range.low) return "at least " + WithUnit(*range.low, unit);
  return range.high ? "at most " + WithUnit(*range.high, unit) : "any";
}

std::string ToText(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", number);
  return text;
}

double InSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

std::string SecondsText(Duration duration) { return ToText(InSeconds(duration)) + " s"; }

}  // namespace coppice::robot::monitoring
