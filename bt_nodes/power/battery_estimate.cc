#include "bt_nodes/power/battery_estimate.h"

#include <algorithm>

namespace coppice::leaves {
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

}  // namespace coppice::leaves
