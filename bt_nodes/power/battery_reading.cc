#include "bt_nodes/power/battery_reading.h"

#include <algorithm>
#include <cmath>

namespace coppice::leaves {
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

}  // namespace coppice::leaves

namespace coppice {

bool ValueTraits<leaves::BatteryReading>::Parse(std::string_view text,
                                                leaves::BatteryReading& out) {
  leaves::BatteryReading reading;
  std::int64_t stamp = 0;
  if (!ValueTraits<std::int64_t>::Parse(leaves::NextField(text), stamp)) return false;
  reading.stamp = TimeFromNanoseconds(stamp);
  for (double* number : {&reading.voltage, &reading.current, &reading.level, &reading.charge}) {
    if (!ValueTraits<double>::Parse(leaves::NextField(text), *number)) return false;
    if (std::isinf(*number)) return false;
  }
  if (text.size() != 1 || text[0] < '0' || text[0] > '4') return false;
  reading.charger = static_cast<leaves::ChargerState>(text[0] - '0');
  out = reading;
  return true;
}

std::string ValueTraits<leaves::BatteryReading>::Print(const leaves::BatteryReading& value) {
  std::string text = std::to_string(ToNanoseconds(value.stamp));
  for (const double number : {value.voltage, value.current, value.level, value.charge}) {
    text += ";" + leaves::PrintNumber(number);
  }
  return text + ";" + std::to_string(static_cast<int>(value.charger));
}

}  // namespace coppice
