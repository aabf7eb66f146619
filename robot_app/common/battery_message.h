// The one place where sensor_msgs/BatteryState is understood.
#ifndef COPPICE_ROBOT_APP_COMMON_BATTERY_MESSAGE_H_
#define COPPICE_ROBOT_APP_COMMON_BATTERY_MESSAGE_H_

#include <sensor_msgs/BatteryState.h>

#include "bt_nodes/power/battery_reading.h"

namespace coppice::robot {

/// What is not finite, or a percentage outside 0..1, is not measured. A battery that its charger
/// calls full has the level 1, whatever its gauge says: else who waits for the last hundredths
/// without a current would wait for ever. `stamp`: of the receiver's clock.
leaves::BatteryReading ToBatteryReading(const sensor_msgs::BatteryState& message, Time stamp);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_BATTERY_MESSAGE_H_
