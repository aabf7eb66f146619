#include "bt_nodes/monitoring/monitoring_leaves.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"

namespace coppice::leaves {
namespace {

Health OneError(const std::string& monitor) {
  Health health;
  health.entries = {
      {monitor, "/navigation", "/navigation", HealthLevel::kError, "does not answer"}};
  return health;
}

TEST(ReadHealth, FailsBeforeTheFirstReport) {
  LeafHarness harness = LeafHarness::For<ReadHealth>();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "no monitor has reported yet");
}

TEST(ReadHealth, PassesAFreshReportOn) {
  LeafHarness harness = LeafHarness::For<ReadHealth>();
  harness.Set("monitoring", OneError("node"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<Health>("health").entries.size(), 1u);
  EXPECT_EQ(harness.Get<int>("errors"), 1);
}

TEST(ReadHealth, FailsWhenTheReportIsTooOld) {
  LeafHarness harness = LeafHarness::For<ReadHealth>();
  harness.Set("monitoring", OneError("node"));
  harness.Advance(std::chrono::seconds(11));
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_FALSE(harness.WasWritten("health"));
}

TEST(NodeFault, NamesTheNodeToRestart) {
  LeafHarness harness = LeafHarness::For<NodeFault>();
  harness.Set("health", OneError("node"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<std::string>("node"), "/navigation");
}

TEST(NodeFault, IgnoresFaultsOfOtherMonitors) {
  LeafHarness harness = LeafHarness::For<NodeFault>();
  harness.Set("health", OneError("topic"));
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(TopicFault, LooksAtTopics) {
  LeafHarness harness = LeafHarness::For<TopicFault>();
  harness.Set("health", OneError("topic"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(LoggerFault, LooksAtLoggers) {
  LeafHarness harness = LeafHarness::For<LoggerFault>();
  harness.Set("health", OneError("logger"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(NavigationFault, LooksAtTheNavigation) {
  LeafHarness harness = LeafHarness::For<NavigationFault>();
  harness.Set("health", OneError("navigation"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(LocalizationFault, LooksAtTheLocalization) {
  LeafHarness harness = LeafHarness::For<LocalizationFault>();
  harness.Set("health", OneError("localization"));
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(EmergencyStopFault, IsNotSeenWhereTheMonitorHasFallenSilent) {
  Health health;
  health.entries = {{"emergency_stop", "/emergency_stop", "", HealthLevel::kStale, "silent"}};
  LeafHarness harness = LeafHarness::For<EmergencyStopFault>();
  harness.Set("health", health);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  health.entries[0].level = HealthLevel::kError;
  harness.Set("health", health);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(SupervisorFault, IsItsOwnSilenceAndNotThatOfItsMonitor) {
  Health health;
  health.entries = {{"supervisor", "/processes", "/supervisor", HealthLevel::kStale, "silent"}};
  LeafHarness harness = LeafHarness::For<SupervisorFault>();
  harness.Set("health", health);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  health.entries[0].level = HealthLevel::kError;
  harness.Set("health", health);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(FaultConditions, AskForTheirOwnKindOfMonitor) {
  Health health;
  health.entries = {{"docking", "station", "", HealthLevel::kError, "missed"}};
  LeafHarness docking = LeafHarness::For<DockingFault>();
  docking.Set("health", health);
  EXPECT_EQ(docking.Tick(), Status::kSuccess);
  LeafHarness charging = LeafHarness::For<ChargingFault>();
  charging.Set("health", health);
  EXPECT_EQ(charging.Tick(), Status::kFailure);
  LeafHarness stop = LeafHarness::For<EmergencyStopFault>();
  stop.Set("health", health);
  EXPECT_EQ(stop.Tick(), Status::kFailure);
}

TEST(NodeIsWell, AsksWhetherAMonitorBlamesThatNode) {
  LeafHarness harness = LeafHarness::For<NodeIsWell>();
  harness.Set("node", std::string("/navigation"));
  Health health;
  const auto tick = [&] {
    harness.Set("health", health);
    return harness.Tick();
  };
  EXPECT_EQ(tick(), Status::kSuccess);
  health.entries = {{"node", "/docking", "/docking", HealthLevel::kError, "dead"},
                    {"topic", "/scan", "/navigation", HealthLevel::kWarn, "slow"},
                    {"navigation", "progress", "/navigation", HealthLevel::kError, "blocked"}};
  EXPECT_EQ(tick(), Status::kSuccess);
  health.entries[1].level = HealthLevel::kStale;
  EXPECT_EQ(tick(), Status::kFailure);
}

}  // namespace
}  // namespace coppice::leaves
