#include "bt_nodes/power/battery_reading.h"

#include <algorithm>
#include <cmath>

namespace coppice {
namespace {

// Takes the text up to the next ';' off the front.
std::string_view NextField(std::string_view& text) {
  const std::size_t end = std::min(text.find(';'), text.size());
  const std::string_view field = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return field;
}

std::string PrintNumber(double value) {
  return std::isnan(value) ? "nan" : ValueTraits<double>::Print(value);
}

}  // namespace

std::optional<bool> CurrentFlows(const BatteryReading& reading, double charging_above) {
  if (reading.charger != ChargerState::kUnknown) return reading.charger == ChargerState::kCharging;
  if (std::isnan(reading.current)) return std::nullopt;
  return reading.current > charging_above;
}

std::optional<bool> StandsOnStation(const BatteryReading& reading, double charging_above) {
  if (reading.charger != ChargerState::kUnknown) {
    return reading.charger != ChargerState::kDischarging;
  }
  if (reading.current > charging_above) return true;
  if (reading.current < -charging_above) return false;
  return std::nullopt;
}

bool ValueTraits<BatteryReading>::Parse(std::string_view text, BatteryReading& out) {
  BatteryReading reading;
  std::int64_t stamp = 0;
  if (!ValueTraits<std::int64_t>::Parse(NextField(text), stamp)) return false;
  reading.stamp = Time(stamp);
  for (double* number : {&reading.voltage, &reading.current, &reading.level, &reading.charge}) {
    if (!ValueTraits<double>::Parse(NextField(text), *number)) return false;
    if (std::isinf(*number)) return false;
  }
  if (text.size() != 1 || text[0] < '0' || text[0] > '4') return false;
  reading.charger = static_cast<ChargerState>(text[0] - '0');
  out = reading;
  return true;
}

std::string ValueTraits<BatteryReading>::Print(const BatteryReading& value) {
  std::string text = std::to_string(value.stamp.count());
  for (const double number : {value.voltage, value.current, value.level, value.charge}) {
    text += ";" + PrintNumber(number);
  }
  return text + ";" + std::to_string(static_cast<int>(value.charger));
}

}  // namespace coppice
