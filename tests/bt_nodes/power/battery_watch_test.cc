#include "bt_nodes/power/battery_watch.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

// A battery that reports once a second.
class BatteryWatchTest : public testing::Test {
 protected:
  Time Now() const {
    return Time(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(now_)));
  }

  // What a battery with this state of charge reports while this current flows.
  static BatteryReading Reading(double level, double current) {
    const BatteryModel model;
    const double open = model.empty_voltage + level * (model.full_voltage - model.empty_voltage);
    BatteryReading reading;
    reading.voltage = open + current * model.resistance;
    reading.current = current;
    reading.level = level;
    return reading;
  }

  const BatteryVerdict& Tell(BatteryReading reading, double distance = 10) {
    now_ += 1;
    reading.stamp = Now();
    return watch_.Update(reading.stamp, &reading, distance);
  }
  const BatteryVerdict& TellFor(double seconds, const BatteryReading& reading,
                                double distance = 10) {
    for (; seconds > 1; --seconds) Tell(reading, distance);
    return Tell(reading, distance);
  }
  const BatteryVerdict& Silence(double seconds) {
    now_ += seconds;
    return watch_.Update(Now(), nullptr, 10);
  }

  double now_ = 1000;
  BatteryWatch watch_;
};

TEST_F(BatteryWatchTest, LeavesAChargedRobotAlone) {
  const BatteryVerdict& verdict = TellFor(600, Reading(0.9, -15));
  EXPECT_FALSE(verdict.due) << verdict.reason;
  EXPECT_FALSE(verdict.critical);
  EXPECT_EQ(verdict.reason, "");
}

// 9 Ah of reserve are 12 % of 75 Ah; ten metres to the station take 0.15 Ah.
TEST_F(BatteryWatchTest, IsDueBeforeTheReserveIsTouched) {
  EXPECT_FALSE(Tell(Reading(0.14, -15)).due);
  EXPECT_TRUE(TellFor(600, Reading(0.12, -15)).due);
  EXPECT_NE(Tell(Reading(0.12, -15)).reason.find("Ah are needed"), std::string::npos);
}

TEST_F(BatteryWatchTest, IsDueTheEarlierTheFartherTheStation) {
  EXPECT_FALSE(Tell(Reading(0.2, -15), 10).due);
  EXPECT_TRUE(Tell(Reading(0.2, -15), 500).due);
}

// The fault of 9 March: no message, whatever the decision node thinks of the level.
TEST_F(BatteryWatchTest, BelievesTheVoltageWhenTheReportedLevelIsStuck) {
  BatteryReading reading = Reading(0.1, -15);
  reading.level = 0.9;
  EXPECT_TRUE(TellFor(120, reading).due);
}

TEST_F(BatteryWatchTest, BelievesTheCountWhenLevelAndVoltageAreStuck) {
  Tell(Reading(0.5, -15));
  EXPECT_FALSE(TellFor(3600, Reading(0.5, -15)).due);
  EXPECT_TRUE(TellFor(5400, Reading(0.5, -15)).due);
}

TEST_F(BatteryWatchTest, IsDueFourHoursAfterTheLastCharge) {
  EXPECT_FALSE(TellFor(4 * 3600, Reading(0.9, -1)).due);
  EXPECT_TRUE(TellFor(10, Reading(0.9, -1)).due);
  EXPECT_NE(Tell(Reading(0.9, -1)).reason.find("last charge"), std::string::npos);
}

TEST_F(BatteryWatchTest, CountsOnlyAChargeThatLasted) {
  TellFor(3 * 3600, Reading(0.8, -1));
  TellFor(60, Reading(0.8, 12));
  EXPECT_TRUE(TellFor(3700, Reading(0.8, -1)).due);
}

TEST_F(BatteryWatchTest, BeginsToCountAnewAfterACharge) {
  TellFor(3 * 3600, Reading(0.8, -1));
  TellFor(700, Reading(0.8, 12));
  EXPECT_FALSE(TellFor(3 * 3600, Reading(0.8, -1)).due);
}

TEST_F(BatteryWatchTest, IsDueWhenTheBatteryFallsSilent) {
  Tell(Reading(0.9, -15));
  EXPECT_FALSE(Silence(59).due);
  EXPECT_TRUE(Silence(2).due);
  EXPECT_NE(Silence(1).reason.find("silent"), std::string::npos);
}

TEST_F(BatteryWatchTest, CountsTheDrivingCurrentWhileTheBatteryIsSilent) {
  Tell(Reading(0.5, -15));
  Silence(61);
  const double before = Silence(1).charge;
  EXPECT_NEAR(Silence(3600).charge, before - 15, 0.1);
}

TEST_F(BatteryWatchTest, IsDueWhenTheBatteryHasNeverReported) {
  Silence(0);
  EXPECT_TRUE(Silence(61).due);
}

TEST_F(BatteryWatchTest, StandsByARequestUntilTheBatteryIsCharged) {
  ASSERT_TRUE(TellFor(60, Reading(0.1, -15)).due);
  EXPECT_TRUE(TellFor(60, Reading(0.1, 12)).due);
  EXPECT_TRUE(TellFor(300, Reading(0.8, 12)).due);
  EXPECT_FALSE(TellFor(300, Reading(0.95, 12)).due);
}

TEST_F(BatteryWatchTest, DoesNotSettleARequestWithoutCurrent) {
  ASSERT_TRUE(TellFor(60, Reading(0.1, -15)).due);
  EXPECT_TRUE(TellFor(300, Reading(0.95, 0)).due);
}

TEST_F(BatteryWatchTest, ForgetsOnTheStationWhatItCountedTooMuch) {
  Tell(Reading(0.9, -15));
  Silence(3600);
  ASSERT_TRUE(TellFor(60, Reading(0.95, -15)).due);
  EXPECT_FALSE(TellFor(300, Reading(0.95, 12)).due);
}

TEST_F(BatteryWatchTest, IsCriticalWhenHalfOfWhatIsNeededIsGone) {
  EXPECT_FALSE(TellFor(60, Reading(0.07, -15)).critical);
  EXPECT_TRUE(TellFor(300, Reading(0.05, -15)).critical);
  EXPECT_FALSE(TellFor(10, Reading(0.05, 12)).critical);
}

// 1.5 Ah are 2 % of 75 Ah.
TEST_F(BatteryWatchTest, IsExhaustedWhenTheWayHomeTakesAllThatIsLeft) {
  EXPECT_FALSE(TellFor(60, Reading(0.03, -15), 10).exhausted);
  EXPECT_TRUE(Tell(Reading(0.03, -15), 500).exhausted) << "7.4 Ah for the way";
  EXPECT_TRUE(Tell(Reading(0.03, -5), 10).exhausted) << "latched";
}

TEST_F(BatteryWatchTest, IsExhaustedNearTheStationToo) {
  EXPECT_FALSE(TellFor(60, Reading(0.025, -15), 0).exhausted);
  EXPECT_TRUE(TellFor(120, Reading(0.015, -15), 0).exhausted);
}

TEST_F(BatteryWatchTest, IsNotExhaustedAnyMoreWhenCurrentFlows) {
  EXPECT_TRUE(TellFor(120, Reading(0.01, -15)).exhausted);
  EXPECT_FALSE(Tell(Reading(0.01, 12)).exhausted);
}

TEST_F(BatteryWatchTest, WhatIsOnlyCountedExhaustsNobody) {
  Tell(Reading(0.3, -15));
  EXPECT_TRUE(Silence(6 * 3600).critical);
  EXPECT_FALSE(Silence(1).exhausted);
  EXPECT_FALSE(Tell(Reading(0.3, -15)).exhausted);
}

TEST_F(BatteryWatchTest, ReadingsWithoutLevelAndVoltageCountAsSilence) {
  Tell(Reading(0.9, -6));
  BatteryReading blind;
  blind.current = -6;
  EXPECT_FALSE(TellFor(55, blind).due);
  EXPECT_TRUE(TellFor(10, blind).due);
  EXPECT_NE(Tell(blind).reason.find("silent"), std::string::npos);
}

TEST_F(BatteryWatchTest, AVoltageThatIsNotMeasuredIsNotZero) {
  BatteryReading reading = Reading(0.9, -6);
  reading.voltage = kNotMeasured;
  const BatteryVerdict& verdict = TellFor(100, reading);
  EXPECT_FALSE(verdict.due) << verdict.reason;
  EXPECT_FALSE(verdict.exhausted);
}

TEST_F(BatteryWatchTest, ACurrentThatIsNotMeasuredCountsAsThatOfDriving) {
  BatteryReading reading = Reading(0.9, 0);
  reading.current = kNotMeasured;
  Tell(reading);
  EXPECT_NEAR(TellFor(3600, reading).charge, 0.9 * 75 - 15, 0.1);
}

TEST_F(BatteryWatchTest, AFullBatteryOnItsStationIsNeverDueHoweverLongItStands) {
  BatteryReading full = Reading(1, 0);
  full.charger = ChargerState::kFull;
  EXPECT_FALSE(TellFor(5 * 3600, full).due);
}

TEST_F(BatteryWatchTest, AChargerThatSaysFullSettlesTheRequest) {
  EXPECT_TRUE(Tell(Reading(0.05, -15)).due);
  BatteryReading full = Reading(0.8, 0);  // the voltage has sunk already
  full.level = 1;
  full.charger = ChargerState::kFull;
  EXPECT_FALSE(Tell(full).due);
}

}  // namespace
}  // namespace coppice::leaves
