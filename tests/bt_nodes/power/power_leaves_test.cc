#include "bt_nodes/power/power_leaves.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"

namespace coppice::leaves {
namespace {

TEST(IsBatteryLow, ComparesTheLevelWithTheThreshold) {
  LeafHarness harness = LeafHarness::For<IsBatteryLow>();
  harness.Set("threshold", 0.3);
  harness.Set("level", 0.29);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  harness.Set("level", 0.3);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(IsBatteryLow, SaysNothingBeforeTheLevelIsKnown) {
  LeafHarness harness = LeafHarness::For<IsBatteryLow>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_FALSE(harness.message().empty());
}

TEST(IsBatteryLow, HoldsForALevelThatIsNotKnown) {
  LeafHarness harness = LeafHarness::For<IsBatteryLow>();
  for (const double unknown : {-1.0, kNotMeasured}) {
    harness.Set("level", unknown);
    EXPECT_EQ(harness.Tick(), Status::kSuccess) << unknown;
  }
}

TEST(IsDocked, AndItsOppositeFollowTheirInput) {
  LeafHarness docked = LeafHarness::For<IsDocked>(), away = LeafHarness::For<IsNotDocked>();
  for (LeafHarness* harness : {&docked, &away}) harness->Set("docked", true);
  EXPECT_EQ(docked.Tick(), Status::kSuccess);
  EXPECT_EQ(away.Tick(), Status::kFailure);
  for (LeafHarness* harness : {&docked, &away}) harness->Set("docked", false);
  EXPECT_EQ(docked.Tick(), Status::kFailure);
  EXPECT_EQ(away.Tick(), Status::kSuccess);
}

TEST(IsDocked, AndItsOppositeFailBeforeAnythingIsKnown) {
  EXPECT_EQ(LeafHarness::For<IsDocked>().Tick(), Status::kFailure);
  EXPECT_EQ(LeafHarness::For<IsNotDocked>().Tick(), Status::kFailure);
}

TEST(IsCharging, FollowsItsInput) {
  LeafHarness harness = LeafHarness::For<IsCharging>();
  harness.Set("charging", true);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  harness.Set("charging", false);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(IsNotCharging, IsTheOppositeOnceTheStateIsKnown) {
  LeafHarness harness = LeafHarness::For<IsNotCharging>();
  harness.Set("charging", true);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  harness.Set("charging", false);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(IsNotCharging, FailsBeforeTheStateIsKnown) {
  LeafHarness harness = LeafHarness::For<IsNotCharging>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(WaitForBattery, RunsUntilTheStateIsKnown) {
  LeafHarness harness = LeafHarness::For<WaitForBattery>();
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Set("docked", false);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(Charge, GoesOnWhileTheLevelIsNotKnown) {
  LeafHarness harness = LeafHarness::For<Charge>();
  harness.Set("charging", true);
  harness.Set("level", -1.0);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
}

TEST(Charge, RunsWhileCurrentFlowsAndEndsWhenFull) {
  LeafHarness harness = LeafHarness::For<Charge>();
  harness.Set("charging", true);
  harness.Set("level", 0.5);
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  harness.Set("level", 0.95);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(Charge, FailsWhenTheCurrentStops) {
  LeafHarness harness = LeafHarness::For<Charge>();
  harness.Set("charging", true);
  harness.Set("level", 0.5);
  harness.Tick();
  harness.Set("charging", false);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "on the station, but no current flows");
}

TEST(ChargeDue, HoldsFromTheTimeTheReserveIsTouched) {
  LeafHarness harness = LeafHarness::For<ChargeDue>();
  Time stamp{};
  const auto tell = [&](double level) {
    stamp += std::chrono::seconds(1);
    harness.Advance(std::chrono::seconds(1));
    harness.Set("battery", BatteryReading{stamp, 23 + 2.4 * level, 0, level, kNotMeasured, {}});
    return harness.Tick();
  };
  harness.Set("distance", 10.0);
  EXPECT_EQ(tell(0.5), Status::kFailure);
  EXPECT_EQ(tell(0.05), Status::kSuccess);
  EXPECT_NE(harness.Get<std::string>("reason").find("Ah are left"), std::string::npos);
  EXPECT_EQ(tell(0.5), Status::kSuccess);
}

TEST(ChargeDue, HoldsWhenTheBatteryNeverReports) {
  LeafHarness harness = LeafHarness::For<ChargeDue>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  harness.Advance(std::chrono::seconds(61));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_FALSE(harness.Get<bool>("critical"));
}

double Planned(const LeafHarness& harness, const std::string& port) {
  return harness.Get<double>(port);
}

TEST(PlanCharge, WithoutWorkingHoursItChargesToTheFull) {
  LeafHarness harness = LeafHarness::For<PlanCharge>();
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_DOUBLE_EQ(Planned(harness, "low_below"), 0.3);
  EXPECT_DOUBLE_EQ(Planned(harness, "until"), 0.95);
}

// 75 Ah, 11 A: 0.147 an hour.
TEST(PlanCharge, ChargesForTheRestOfTheDayAndLeavesTheReserve) {
  LeafHarness harness = LeafHarness::For<PlanCharge>();
  harness.Set("duty_left", 3 * 3600.0);
  harness.Tick();
  EXPECT_NEAR(Planned(harness, "until"), 0.15 + 0.44, 1e-9);
  EXPECT_DOUBLE_EQ(Planned(harness, "low_below"), 0.5);
  harness.Set("duty_left", 8 * 3600.0);
  harness.Tick();
  EXPECT_DOUBLE_EQ(Planned(harness, "until"), 0.95) << "it cannot hold more";
}

TEST(PlanCharge, TowardsTheEndOfTheDayTheBatteryIsLowOnlyAtTheReserve) {
  LeafHarness harness = LeafHarness::For<PlanCharge>();
  harness.Set("duty_left", 1800.0);
  harness.Tick();
  EXPECT_NEAR(Planned(harness, "low_below"), 0.15 + 0.0733 - 0.05, 1e-3);
  harness.Set("duty_left", 60.0);
  harness.Tick();
  EXPECT_DOUBLE_EQ(Planned(harness, "low_below"), 0.15);
  EXPECT_GT(Planned(harness, "until"), 0.15) << "else it would come back at once";
}

TEST(PlanCharge, AtNightItChargesToTheFull) {
  LeafHarness harness = LeafHarness::For<PlanCharge>();
  harness.Set("duty_left", 0.0);
  harness.Tick();
  EXPECT_DOUBLE_EQ(Planned(harness, "until"), 0.95);
}

TEST(PlanCharge, WhenRequestedItChargesAsFarAsTheWatchdogWants) {
  LeafHarness harness = LeafHarness::For<PlanCharge>();
  harness.Set("requested", true);
  harness.Set("duty_left", 600.0);
  harness.Tick();
  EXPECT_DOUBLE_EQ(Planned(harness, "until"), 0.4);
  harness.Set("duty_left", 3 * 3600.0);
  harness.Tick();
  EXPECT_NEAR(Planned(harness, "until"), 0.15 + 0.44, 1e-9) << "the day needs more";
}

}  // namespace
}  // namespace coppice::leaves
