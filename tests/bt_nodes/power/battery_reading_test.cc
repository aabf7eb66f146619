#include "bt_nodes/power/battery_reading.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::leaves {
namespace {

BatteryReading Reading(ChargerState charger, double current) {
  BatteryReading reading;
  reading.charger = charger;
  reading.current = current;
  return reading;
}

TEST(BatteryReading, AFullBatteryStandsOnTheStationAlthoughNoCurrentFlows) {
  const BatteryReading full = Reading(ChargerState::kFull, 0);
  EXPECT_EQ(StandsOnStation(full), true);
  EXPECT_EQ(CurrentFlows(full), false);
}

TEST(BatteryReading, TheChargersWordCountsMoreThanTheCurrent) {
  const BatteryReading away = Reading(ChargerState::kDischarging, 3);  // brakes, and recuperates
  EXPECT_EQ(StandsOnStation(away), false);
  EXPECT_EQ(CurrentFlows(away), false);
  EXPECT_EQ(StandsOnStation(Reading(ChargerState::kNotCharging, -6)), true);
}

TEST(BatteryReading, WhereTheChargerSaysNothingTheCurrentTells) {
  EXPECT_EQ(StandsOnStation(Reading(ChargerState::kUnknown, 12)), true);
  EXPECT_EQ(CurrentFlows(Reading(ChargerState::kUnknown, 12)), true);
  EXPECT_EQ(StandsOnStation(Reading(ChargerState::kUnknown, -6)), false);
  EXPECT_EQ(CurrentFlows(Reading(ChargerState::kUnknown, -6)), false);
}

TEST(BatteryReading, WhatNeitherTellsIsNotKnown) {
  EXPECT_EQ(StandsOnStation(Reading(ChargerState::kUnknown, 0)), std::nullopt);
  EXPECT_EQ(StandsOnStation({}), std::nullopt);
  EXPECT_EQ(CurrentFlows({}), std::nullopt);
}

TEST(BatteryReading, IsTheSameAfterPrintingAndParsing) {
  const BatteryReading reading{Time(Duration(5000000000)), 24.25, -15.5, 0.5, 37.5,
                               ChargerState::kFull};
  BatteryReading parsed;
  ASSERT_TRUE(
      ValueTraits<BatteryReading>::Parse(ValueTraits<BatteryReading>::Print(reading), parsed));
  EXPECT_EQ(parsed.stamp, reading.stamp);
  EXPECT_EQ(parsed.voltage, reading.voltage);
  EXPECT_EQ(parsed.current, reading.current);
  EXPECT_EQ(parsed.level, reading.level);
  EXPECT_EQ(parsed.charge, reading.charge);
  EXPECT_EQ(parsed.charger, reading.charger);
}

TEST(BatteryReading, WhatIsNotMeasuredStaysSoInText) {
  const std::string text = ValueTraits<BatteryReading>::Print({});
  EXPECT_EQ(text, "0;nan;nan;nan;nan;0");
  BatteryReading parsed{Time(Duration(1)), 1, 1, 1, 1, ChargerState::kFull};
  ASSERT_TRUE(ValueTraits<BatteryReading>::Parse(text, parsed));
  EXPECT_TRUE(std::isnan(parsed.level));
}

TEST(BatteryReading, IsNotReadFromTextThatIsNone) {
  BatteryReading parsed;
  for (const char* text : {"", "1", "1;2;3;4;5", "1;2;3;4;5;", "1;2;3;4;5;5", "1;2;3;4;5;1;",
                           "1;2;3;4;5;12", "x;2;3;4;5;1", "1;inf;3;4;5;1", "1;2;3;;5;1"}) {
    EXPECT_FALSE(ValueTraits<BatteryReading>::Parse(text, parsed)) << text;
  }
}

}  // namespace
}  // namespace coppice::leaves
