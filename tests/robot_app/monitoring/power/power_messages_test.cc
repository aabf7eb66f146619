#include "robot_app/monitoring/power/power_messages.h"

#include <gtest/gtest.h>

namespace coppice::robot {
namespace {

TEST(PowerMessages, TheNumbersOfTheBatteryAreKept) {
  sensor_msgs::BatteryState message;
  message.voltage = 24.5f;
  message.current = -6.25f;
  message.charge = 60;
  message.percentage = 0.8f;
  const BatterySample sample = FromMessage(message);
  EXPECT_FLOAT_EQ(sample.voltage, 24.5);
  EXPECT_FLOAT_EQ(sample.current, -6.25);
  EXPECT_FLOAT_EQ(sample.charge, 60);
  EXPECT_FLOAT_EQ(sample.level, 0.8);
}

TEST(PowerMessages, TheStatusTellsWhetherTheContactsTouch) {
  using State = sensor_msgs::BatteryState;
  const struct {
    int status;
    bool on_charger, is_full;
  } kRows[] = {{State::POWER_SUPPLY_STATUS_UNKNOWN, false, false},
               {State::POWER_SUPPLY_STATUS_DISCHARGING, false, false},
               {State::POWER_SUPPLY_STATUS_CHARGING, true, false},
               {State::POWER_SUPPLY_STATUS_NOT_CHARGING, true, false},
               {State::POWER_SUPPLY_STATUS_FULL, true, true}};
  for (const auto& row : kRows) {
    State message;
    message.power_supply_status = static_cast<std::uint8_t>(row.status);
    EXPECT_EQ(FromMessage(message).on_charger, row.on_charger) << row.status;
    EXPECT_EQ(FromMessage(message).is_full, row.is_full) << row.status;
  }
}

TEST(PowerMessages, GoalsKeepTheirIdsAndPhases) {
  using Status = actionlib_msgs::GoalStatus;
  EXPECT_EQ(static_cast<int>(GoalPhase::kActive), +Status::ACTIVE);
  EXPECT_EQ(static_cast<int>(GoalPhase::kPreempted), +Status::PREEMPTED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kSucceeded), +Status::SUCCEEDED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kAborted), +Status::ABORTED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kRejected), +Status::REJECTED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kPreempting), +Status::PREEMPTING);
  EXPECT_EQ(static_cast<int>(GoalPhase::kRecalling), +Status::RECALLING);
  EXPECT_EQ(static_cast<int>(GoalPhase::kRecalled), +Status::RECALLED);
  EXPECT_EQ(static_cast<int>(GoalPhase::kLost), +Status::LOST);
  actionlib_msgs::GoalStatusArray message;
  message.status_list.resize(2);
  message.status_list[1].goal_id.id = "second";
  message.status_list[1].status = Status::ABORTED;
  message.status_list[1].text = "no current";
  const auto goals = FromMessage(message);
  ASSERT_EQ(goals.size(), 2u);
  EXPECT_EQ(goals[1].id, "second");
  EXPECT_EQ(goals[1].phase, GoalPhase::kAborted);
  EXPECT_EQ(goals[1].message, "no current");
}

}  // namespace
}  // namespace coppice::robot
