#include "robot_app/monitoring/power/battery_monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coppice::robot::monitoring {
namespace {

using leaves::ChargerState;
using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Band AtMost(double warn, double error) {
  return {{std::nullopt, warn}, {std::nullopt, error}, 1, Duration::zero(), 0};
}
Band AtLeast(double warn, double error) {
  return {{warn, std::nullopt}, {error, std::nullopt}, 1, Duration::zero(), 0};
}

BatteryLimits Watch() {
  BatteryLimits watch;
  watch.topic = "/battery_state";
  watch.node = "/base";
  watch.staleness = seconds(5);
  watch.voltage = {{23.5, 29}, {23, 30}, 1, Duration::zero(), 0};
  watch.current = {{-25, 20}, {-40, 30}, 1, Duration::zero(), 0};
  watch.charge = AtLeast(0.25, 0.15);
  watch.coulombs = {{-2, 2}, {-4, 4}, 1, Duration::zero(), 0};
  watch.unchanged = AtMost(60, 180);
  watch.since_charge = AtMost(3600, 7200);
  watch.margin = AtLeast(3, 0);
  watch.model.driving_current = 36;  // 0.01 Ah per second and metre
  watch.model.driving_speed = 1;
  watch.model.docking_attempts = 3;
  watch.model.attempt_time = 0;
  watch.model.help_time = 0;
  return watch;
}

class BatteryMonitorTest : public testing::Test {
 protected:
  BatteryMonitorTest() { monitor_.Watch(Watch()); }

  // The battery as it is after `time` with its current.
  void Drive(Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      now_ += seconds(1);
      reading_.charge += reading_.current / 3600;
      reading_.level = reading_.charge / 75;
      monitor_.OnReading(reading_, {now_, wall_});
    }
  }
  Finding About(const std::string& subject) {
    for (const Finding& finding : monitor_.Report(processes_, {now_, wall_})) {
      EXPECT_EQ(finding.monitor, "battery");
      if (finding.subject == subject) return finding;
    }
    ADD_FAILURE() << "nothing about " << subject;
    return {};
  }

  BatteryMonitor monitor_;
  ProcessTable processes_;
  leaves::BatteryReading reading_{{}, 25, -6, 0.8, 60, ChargerState::kDischarging};
  Time now_ = Time(seconds(1000)), wall_{Time(Duration(0))};
};

TEST_F(BatteryMonitorTest, AHealthyBatteryIsWellInEveryNumber) {
  Drive(seconds(600));
  for (const Finding& finding : monitor_.Report(processes_, {now_, wall_})) {
    EXPECT_EQ(finding.level, HealthLevel::kOk) << finding.subject << ": " << finding.message;
  }
  EXPECT_NEAR(About("coulombs").value, 0, 0.01);
  EXPECT_NEAR(About("charge").value, 59.0 / 75, 1e-3);
  EXPECT_EQ(About("current").value, -6);
}

TEST_F(BatteryMonitorTest, VoltageIsJudgedOnBothSides) {
  reading_.voltage = 22.9;
  Drive(seconds(1));
  EXPECT_EQ(About("voltage").level, HealthLevel::kError);
  EXPECT_EQ(About("voltage").message, "22.9 V, expected 23 to 30 V");
  reading_.voltage = 29.5;
  Drive(seconds(1));
  EXPECT_EQ(About("voltage").level, HealthLevel::kWarn);
}

TEST_F(BatteryMonitorTest, ALowChargeIsAnError) {
  reading_.charge = 0.1 * 75;
  Drive(seconds(1));
  EXPECT_EQ(About("charge").level, HealthLevel::kError);
}

TEST_F(BatteryMonitorTest, SilenceIsAnErrorOfTheNodeThatPublishes) {
  EXPECT_EQ(About("state").level, HealthLevel::kOk);
  now_ += seconds(5);
  EXPECT_EQ(About("state").level, HealthLevel::kOk);
  now_ += milliseconds(1);
  EXPECT_EQ(About("state").level, HealthLevel::kError);
  EXPECT_EQ(About("state").node, "/base");
  EXPECT_EQ(About("state").message, "/battery_state: no message for 5 s");
  processes_.by_node["/base"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(About("state").level, HealthLevel::kOk);
  processes_.by_node["/base"].phase = ProcessPhase::kReady;
  EXPECT_EQ(About("state").level, HealthLevel::kOk);  // counts anew
}

TEST_F(BatteryMonitorTest, SilenceMustLastInWallTimeToo) {
  BatteryMonitor patient(milliseconds(400));
  patient.Watch(Watch());
  const auto level = [&](Time ros, Time wall) {
    return patient.Report(processes_, {ros, wall}).at(0).level;
  };
  level(Time(seconds(1)), Time(seconds(1)));
  EXPECT_EQ(level(Time(seconds(10)), Time(seconds(2))), HealthLevel::kWarn);
  EXPECT_EQ(level(Time(seconds(20)), Time(seconds(3))), HealthLevel::kError);
}

TEST_F(BatteryMonitorTest, AChargeThatDoesNotFollowTheCurrentIsNoticed) {
  Drive(seconds(10));
  reading_.charge -= 3;
  Drive(seconds(1));
  EXPECT_EQ(About("coulombs").level, HealthLevel::kWarn);
  EXPECT_NEAR(About("coulombs").value, -3, 0.01);
  reading_.current = 12;  // the gauge begins anew with the charge
  Drive(seconds(2));
  EXPECT_EQ(About("coulombs").level, HealthLevel::kOk);
}

TEST_F(BatteryMonitorTest, AFrozenGaugeIsNoticed) {
  Drive(seconds(10));
  for (int i = 0; i < 200; ++i) monitor_.OnReading(reading_, {now_ += seconds(1), wall_});
  EXPECT_EQ(About("unchanged").level, HealthLevel::kError);
  EXPECT_EQ(About("unchanged").value, 200);
  Drive(seconds(1));
  EXPECT_EQ(About("unchanged").level, HealthLevel::kOk);
}

TEST_F(BatteryMonitorTest, AFullBatteryMayStandStill) {
  reading_.current = 0;
  reading_.charge = 75;
  Drive(seconds(1000));
  EXPECT_EQ(About("unchanged").level, HealthLevel::kOk);
}

TEST_F(BatteryMonitorTest, TheTimeSinceTheLastChargeHasABound) {
  Drive(seconds(3601));
  EXPECT_EQ(About("since_charge").level, HealthLevel::kOk);
  Drive(seconds(10));
  EXPECT_EQ(About("since_charge").level, HealthLevel::kWarn);
  reading_.current = 12;
  Drive(seconds(1));
  EXPECT_EQ(About("since_charge").value, 0);
}

TEST_F(BatteryMonitorTest, TheWayToTheStationAndTheReserveMustFitIntoTheCharge) {
  reading_.charge = 5;
  reading_.current = 0;
  monitor_.OnDistance(100);  // 1 Ah
  Drive(seconds(1));
  EXPECT_NEAR(About("margin").value, 4, 1e-9);
  EXPECT_EQ(About("margin").level, HealthLevel::kOk);
  monitor_.OnDistance(300);
  Drive(seconds(1));
  EXPECT_EQ(About("margin").level, HealthLevel::kWarn);
  monitor_.OnDistance(600);
  Drive(seconds(1));
  EXPECT_EQ(About("margin").level, HealthLevel::kError);
}

TEST_F(BatteryMonitorTest, ABatteryWithoutCoulombCounterIsJudgedByItsLevel) {
  reading_.charge = kNan;
  reading_.level = 0.5;
  monitor_.OnReading(reading_, {now_, wall_});
  monitor_.OnReading(reading_, {now_ += seconds(1000), wall_});
  EXPECT_TRUE(std::isnan(About("coulombs").value));
  EXPECT_EQ(About("unchanged").level, HealthLevel::kOk);
  EXPECT_NEAR(About("margin").value, 37.5, 1e-9);
}

TEST_F(BatteryMonitorTest, WhatHasBoundsAndIsNotMeasuredIsAnError) {
  Drive(seconds(10));
  reading_.level = reading_.charge = reading_.voltage = reading_.current = kNan;
  monitor_.OnReading(reading_, {now_ += seconds(1), wall_});
  for (const char* subject : {"voltage", "current", "charge", "margin"}) {
    EXPECT_EQ(About(subject).level, HealthLevel::kError) << subject;
    EXPECT_EQ(About(subject).message, "not measured") << subject;
  }
}

TEST_F(BatteryMonitorTest, WhatHasNoBoundsNeedNotBeMeasured) {
  BatteryLimits watch = Watch();
  watch.voltage = Band();
  monitor_.Watch(watch);
  reading_.voltage = kNan;
  Drive(seconds(10));
  EXPECT_EQ(About("voltage").level, HealthLevel::kOk);
}

TEST_F(BatteryMonitorTest, CountingTheCurrentBeginsAnewAfterAReadingWithoutIt) {
  Drive(seconds(10));
  reading_.current = kNan;
  monitor_.OnReading(reading_, {now_ += seconds(1), wall_});
  reading_.current = -6;
  Drive(seconds(10));
  EXPECT_NEAR(About("coulombs").value, 0, 0.01);
}

TEST_F(BatteryMonitorTest, ABatteryThatNeverTellsWhetherItStandsOnTheStationIsAnError) {
  reading_.charger = ChargerState::kUnknown;
  reading_.current = 0;
  Drive(seconds(7));
  EXPECT_EQ(About("state").level, HealthLevel::kError);
  reading_.current = -6;  // it drives
  Drive(seconds(1));
  EXPECT_EQ(About("state").level, HealthLevel::kOk);
}

TEST_F(BatteryMonitorTest, AFullBatteryOnTheStationIsCharged) {
  Drive(seconds(7300));
  reading_.charger = ChargerState::kFull;
  reading_.current = 0;
  Drive(seconds(1));
  EXPECT_EQ(About("since_charge").level, HealthLevel::kOk);
}

TEST_F(BatteryMonitorTest, AGapInTheReadingsIsNotCounted) {
  Drive(seconds(5));
  now_ += seconds(3600);
  reading_.charge -= 6;
  Drive(seconds(1));
  EXPECT_EQ(About("coulombs").value, 0);
}

TEST_F(BatteryMonitorTest, TimeThatJumpsBackBeginsAnew) {
  Drive(seconds(500));
  now_ = Time(seconds(10));
  Drive(seconds(2));
  EXPECT_EQ(About("since_charge").value, 1);
  EXPECT_EQ(About("state").level, HealthLevel::kOk);
}

TEST_F(BatteryMonitorTest, WithoutAWatchThereIsNothingToSay) {
  monitor_.Watch(std::nullopt);
  Drive(seconds(2));
  EXPECT_TRUE(monitor_.Report(processes_, {now_, wall_}).empty());
}

}  // namespace
}  // namespace coppice::robot::monitoring
