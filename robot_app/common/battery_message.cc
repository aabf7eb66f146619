#include "robot_app/common/battery_message.h"

#include <cmath>

namespace coppice::robot {
namespace {

double Measured(double number) { return std::isfinite(number) ? number : leaves::kNotMeasured; }

}  // namespace

leaves::BatteryReading ToBatteryReading(const sensor_msgs::BatteryState& message, Time stamp) {
  leaves::BatteryReading reading;
  reading.stamp = stamp;
  reading.voltage = Measured(message.voltage);
  reading.current = Measured(message.current);
  reading.charge = Measured(message.charge);
  if (message.power_supply_status <= sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_FULL) {
    reading.charger = static_cast<leaves::ChargerState>(message.power_supply_status);
  }
  const bool is_share = message.percentage >= 0 && message.percentage <= 1;
  if (is_share) reading.level = message.percentage;
  if (reading.charger == leaves::ChargerState::kFull) reading.level = 1;
  return reading;
}

}  // namespace coppice::robot
