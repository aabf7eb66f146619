#include "bt_nodes/power/battery_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace coppice {
namespace {

constexpr double kSecondsPerHour = 3600;

}  // namespace

double LevelFromVoltage(const BatteryModel& model, double voltage, double current) {
  const double unloaded = voltage - current * model.resistance;
  const double range = model.full_voltage - model.empty_voltage;
  return std::clamp((unloaded - model.empty_voltage) / range, 0.0, 1.0);
}

double ChargeToDrive(const BatteryModel& model, double distance) {
  const double hours = std::max(0.0, distance) / model.driving_speed / kSecondsPerHour;
  return hours * model.driving_current;
}

double ChargeReserve(const BatteryModel& model) {
  const double seconds = model.docking_attempts * model.attempt_time + model.help_time;
  return seconds / kSecondsPerHour * model.driving_current;
}

double TimeLeft(const BatteryModel& model, double charge) {
  return std::max(0.0, charge) / model.driving_current * kSecondsPerHour;
}

bool ValueTraits<BatteryReading>::Parse(std::string_view text, BatteryReading& out) {
  const std::size_t end = text.find(';');
  if (end == std::string_view::npos) return false;
  std::int64_t stamp = 0;
  if (!ValueTraits<std::int64_t>::Parse(text.substr(0, end), stamp)) return false;
  text.remove_prefix(end + 1);
  BatteryReading reading{Time(stamp), 0, 0, 0};
  for (double* number : {&reading.voltage, &reading.current, &reading.level}) {
    const std::size_t next = text.find(';');
    const bool is_last = number == &reading.level;
    if (is_last != (next == std::string_view::npos)) return false;
    if (!ValueTraits<double>::Parse(text.substr(0, next), *number)) return false;
    if (!std::isfinite(*number)) return false;
    if (!is_last) text.remove_prefix(next + 1);
  }
  out = reading;
  return true;
}

std::string ValueTraits<BatteryReading>::Print(const BatteryReading& value) {
  const auto print = ValueTraits<double>::Print;
  return std::to_string(value.stamp.count()) + ";" + print(value.voltage) + ";" +
         print(value.current) + ";" + print(value.level);
}

}  // namespace coppice
