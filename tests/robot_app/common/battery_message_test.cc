#include "robot_app/common/battery_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coppice::robot {
namespace {

using State = sensor_msgs::BatteryState;

TEST(BatteryMessage, TheNumbersAreKept) {
  State message;
  message.voltage = 24.5f;
  message.current = -6.25f;
  message.charge = 60;
  message.percentage = 0.8f;
  message.power_supply_status = State::POWER_SUPPLY_STATUS_DISCHARGING;
  const leaves::BatteryReading reading = ToBatteryReading(message, Time(Duration(7)));
  EXPECT_EQ(reading.stamp, Time(Duration(7)));
  EXPECT_FLOAT_EQ(reading.voltage, 24.5);
  EXPECT_FLOAT_EQ(reading.current, -6.25);
  EXPECT_FLOAT_EQ(reading.charge, 60);
  EXPECT_FLOAT_EQ(reading.level, 0.8);
  EXPECT_EQ(reading.charger, leaves::ChargerState::kDischarging);
}

TEST(BatteryMessage, WhatIsNoNumberIsNotMeasured) {
  State message;
  message.voltage = std::numeric_limits<float>::quiet_NaN();
  message.current = std::numeric_limits<float>::infinity();
  message.charge = -std::numeric_limits<float>::infinity();
  message.percentage = std::numeric_limits<float>::quiet_NaN();
  const leaves::BatteryReading reading = ToBatteryReading(message, {});
  for (const double number : {reading.voltage, reading.current, reading.charge, reading.level}) {
    EXPECT_TRUE(std::isnan(number));
  }
}

TEST(BatteryMessage, APercentageThatIsNoShareIsNotMeasured) {
  State message;
  for (const float percentage : {-0.01f, 1.01f, 80.0f}) {
    message.percentage = percentage;
    EXPECT_TRUE(std::isnan(ToBatteryReading(message, {}).level)) << percentage;
  }
}

TEST(BatteryMessage, TheStatusIsKeptAndANewOneIsUnknown) {
  State message;
  for (int status = 0; status <= 5; ++status) {
    message.power_supply_status = static_cast<std::uint8_t>(status);
    EXPECT_EQ(static_cast<int>(ToBatteryReading(message, {}).charger), status % 5);
  }
}

TEST(BatteryMessage, WhatTheChargerCallsFullHasTheLevelOne) {
  State message;
  message.power_supply_status = State::POWER_SUPPLY_STATUS_FULL;
  message.percentage = 0.93f;
  EXPECT_EQ(ToBatteryReading(message, {}).level, 1);
  message.percentage = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ToBatteryReading(message, {}).level, 1);
}

}  // namespace
}  // namespace coppice::robot
