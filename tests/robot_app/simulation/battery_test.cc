#include "robot_app/simulation/battery.h"

#include <gtest/gtest.h>

namespace coppice::robot::simulation {
namespace {

TEST(Battery, DrainsFasterWhenDriving) {
  Battery standing;
  Battery slow;
  Battery fast;
  standing.Step(3600, 0, false);
  slow.Step(3600, 0.01, false);
  fast.Step(3600, 1, false);
  EXPECT_NEAR(75 - standing.charge(), 6.25, 1e-9);
  EXPECT_NEAR(75 - slow.charge(), 15.0, 0.1);
  EXPECT_NEAR(75 - fast.charge(), 18.75, 1e-9);
}

TEST(Battery, LastsFourHoursAtFullSpeed) {
  Battery battery;
  double time = 0;
  for (; !battery.empty(); time += 1) battery.Step(1, 1, false);
  EXPECT_NEAR(time / 3600, 4, 0.01);
  EXPECT_EQ(battery.state_of_charge(), 0);
}

TEST(Battery, ChargesAtTwelveAmperesUntilItIsFull) {
  Battery battery({}, 0.5);
  battery.Step(3600, 0, true);
  EXPECT_TRUE(battery.charging());
  EXPECT_DOUBLE_EQ(battery.current(), 12);
  EXPECT_NEAR(battery.charge(), 49.5, 1e-9);
  for (int i = 0; i < 4; ++i) battery.Step(3600, 0, true);
  EXPECT_TRUE(battery.full());
  EXPECT_FALSE(battery.charging());
  EXPECT_DOUBLE_EQ(battery.state_of_charge(), 1);
}

TEST(Battery, VoltageFallsWithTheChargeAndSagsWithTheCurrent) {
  EXPECT_DOUBLE_EQ(Battery().voltage(), 25.4);
  EXPECT_DOUBLE_EQ(Battery({}, 0).voltage(), 23.0);
  Battery driving({}, 0.5);
  Battery standing({}, 0.5);
  driving.Step(1e-6, 1, false);
  standing.Step(1e-6, 0, false);
  EXPECT_NEAR(driving.voltage(), 24.2 - 18.75 * 0.02, 1e-6);
  EXPECT_LT(driving.voltage(), standing.voltage());
}

TEST(Battery, AnEmptyOneGivesNoCurrent) {
  Battery battery({}, 0);
  battery.Step(1, 1, false);
  EXPECT_EQ(battery.current(), 0);
  EXPECT_EQ(battery.charge(), 0);
}

TEST(Battery, ClampsTheStateOfCharge) {
  EXPECT_EQ(Battery({}, 7).state_of_charge(), 1);
  EXPECT_EQ(Battery({}, -7).state_of_charge(), 0);
}

}  // namespace
}  // namespace coppice::robot::simulation
