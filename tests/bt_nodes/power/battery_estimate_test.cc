#include "bt_nodes/power/battery_estimate.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

TEST(BatteryEstimate, ReadsTheLevelFromTheVoltageWithoutLoad) {
  const BatteryModel model;
  EXPECT_DOUBLE_EQ(LevelFromVoltage(model, 25.4, 0), 1);
  EXPECT_DOUBLE_EQ(LevelFromVoltage(model, 23.0, 0), 0);
  EXPECT_NEAR(LevelFromVoltage(model, 24.2, 0), 0.5, 1e-9);
}

TEST(BatteryEstimate, TakesTheSagUnderLoadAndTheRiseOfChargingOutOfTheVoltage) {
  const BatteryModel model;
  EXPECT_NEAR(LevelFromVoltage(model, 24.2 - 15 * 0.02, -15), 0.5, 1e-9);
  EXPECT_NEAR(LevelFromVoltage(model, 24.2 + 12 * 0.02, 12), 0.5, 1e-9);
}

TEST(BatteryEstimate, NeverReadsALevelOutsideOfZeroToOne) {
  const BatteryModel model;
  EXPECT_DOUBLE_EQ(LevelFromVoltage(model, 28, 0), 1);
  EXPECT_DOUBLE_EQ(LevelFromVoltage(model, 0, 0), 0);
}

// Three attempts of two minutes and half an hour for a person, at 15 A.
TEST(BatteryEstimate, KeepsAReserveForAllDockingAttemptsAndAPersonsWay) {
  EXPECT_DOUBLE_EQ(ChargeReserve({}), 9);
}

TEST(BatteryEstimate, CountsTheWayToTheStationAtTheMeanSpeed) {
  BatteryModel model;
  model.driving_speed = 0.25;
  EXPECT_NEAR(ChargeToDrive(model, 100), 400 / 3600.0 * 15, 1e-9);
  EXPECT_EQ(ChargeToDrive(model, -1), 0);
}

TEST(BatteryEstimate, SaysHowLongTheChargeLasts) {
  EXPECT_DOUBLE_EQ(TimeLeft({}, 7.5), 1800);
  EXPECT_EQ(TimeLeft({}, -1), 0);
}

}  // namespace
}  // namespace coppice::leaves
