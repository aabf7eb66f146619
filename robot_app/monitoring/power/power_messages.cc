#include "robot_app/monitoring/power/power_messages.h"

namespace coppice::robot {

BatterySample FromMessage(const sensor_msgs::BatteryState& message) {
  using State = sensor_msgs::BatteryState;
  BatterySample sample;
  sample.voltage = message.voltage;
  sample.current = message.current;
  sample.charge = message.charge;
  sample.level = message.percentage;
  sample.is_full = message.power_supply_status == State::POWER_SUPPLY_STATUS_FULL;
  sample.on_charger = sample.is_full ||
                      message.power_supply_status == State::POWER_SUPPLY_STATUS_CHARGING ||
                      message.power_supply_status == State::POWER_SUPPLY_STATUS_NOT_CHARGING;
  return sample;
}

std::vector<GoalReport> FromMessage(const actionlib_msgs::GoalStatusArray& message) {
  std::vector<GoalReport> goals;
  for (const actionlib_msgs::GoalStatus& goal : message.status_list) {
    goals.push_back({goal.goal_id.id, static_cast<GoalPhase>(goal.status), goal.text});
  }
  return goals;
}

}  // namespace coppice::robot
