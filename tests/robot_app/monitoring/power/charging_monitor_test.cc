#include "robot_app/monitoring/power/charging_monitor.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::ChargerState;
using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

class ChargingMonitorTest : public testing::Test {
 protected:
  ChargingMonitorTest() {
    ChargingWatch watch;
    watch.current = 0.5;
    watch.within = seconds(10);
    watch.interruption = seconds(4);
    watch.full = 0.95;
    monitor_.Watch(watch);
  }
  Finding After(Duration time, bool on_charger, double current, double level = 0.5,
                bool is_full = false) {
    now_ += time;
    const ChargerState charger = !on_charger     ? ChargerState::kDischarging
                                 : is_full       ? ChargerState::kFull
                                 : current > 0.5 ? ChargerState::kCharging
                                                 : ChargerState::kNotCharging;
    monitor_.OnReading({now_, 24, current, level, 0, charger}, now_);
    return monitor_.Report({}, {now_, now_}).at(0);
  }

  ChargingMonitor monitor_;
  Time now_{seconds(100)};
};

TEST_F(ChargingMonitorTest, OffTheStationAllIsWell) {
  EXPECT_EQ(monitor_.Report({}, {now_, now_}).at(0).message, "state unknown");
  EXPECT_EQ(After(seconds(0), false, -6).level, HealthLevel::kOk);
  EXPECT_EQ(After(seconds(3600), false, -18).level, HealthLevel::kOk);
}

TEST_F(ChargingMonitorTest, AChargeThatFlowsIsWell) {
  After(seconds(0), true, 0);
  EXPECT_EQ(After(seconds(3), true, 12).level, HealthLevel::kOk);
  const Finding finding = After(seconds(3600), true, 12);
  EXPECT_EQ(finding.level, HealthLevel::kOk);
  EXPECT_EQ(finding.monitor, "charging");
  EXPECT_EQ(finding.value, 12);
}

TEST_F(ChargingMonitorTest, ContactWithoutCurrentIsAnErrorAfterItsTime) {
  EXPECT_EQ(After(seconds(0), true, -6).level, HealthLevel::kWarn);
  EXPECT_EQ(After(seconds(10), true, -6).level, HealthLevel::kWarn);
  const Finding finding = After(milliseconds(500), true, -6);
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.message, "contact without current for 10.5 s");
  EXPECT_EQ(After(seconds(1), false, -6).level, HealthLevel::kOk);  // it has left
}

TEST_F(ChargingMonitorTest, ACurrentThatStopsIsAnErrorSooner) {
  After(seconds(0), true, 12);
  EXPECT_EQ(After(seconds(1), true, 0).level, HealthLevel::kWarn);
  EXPECT_EQ(After(seconds(4), true, 0).level, HealthLevel::kWarn);
  const Finding finding = After(milliseconds(100), true, 0);
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.message, "the charging current stopped 4.1 s ago");
  EXPECT_EQ(After(seconds(1), true, 12).level, HealthLevel::kOk);
}

TEST_F(ChargingMonitorTest, ANewContactHasItsTimeAgain) {
  After(seconds(0), true, 12);
  After(seconds(1), false, -6);
  After(seconds(1), true, -6);
  EXPECT_EQ(After(seconds(8), true, -6).level, HealthLevel::kWarn);
}

TEST_F(ChargingMonitorTest, AFullBatteryNeedsNoCurrent) {
  After(seconds(0), true, 12, 0.94);
  EXPECT_EQ(After(seconds(1), true, 0, 0.96).level, HealthLevel::kOk);
  EXPECT_EQ(After(seconds(100), true, 0, 0.96).level, HealthLevel::kOk);
  EXPECT_EQ(After(seconds(100), true, 0, 0.5, true).level,
            HealthLevel::kOk);  // the charger's word
}

TEST_F(ChargingMonitorTest, SilenceOfTheBatteryIsNoLackOfCurrent) {
  After(seconds(0), true, -6);
  EXPECT_EQ(monitor_.Report({}, {now_ + seconds(100), now_}).at(0).level, HealthLevel::kWarn);
}

TEST_F(ChargingMonitorTest, WithoutAWatchThereIsNothingToSay) {
  monitor_.Watch(std::nullopt);
  EXPECT_TRUE(monitor_.Report({}, {now_, now_}).empty());
}

}  // namespace
}  // namespace coppice::robot::monitoring
