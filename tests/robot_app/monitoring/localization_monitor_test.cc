#include "robot_app/monitoring/localization_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::seconds;

Times At(Time now) { return {now, now}; }

class LocalizationMonitorTest : public testing::Test {
 protected:
  LocalizationMonitorTest() {
    LocalizationWatch watch;
    watch.topic = "/localization/state";
    watch.node = "/localization";
    watch.staleness = seconds(3);
    watch.since_confirmed = {{std::nullopt, 10}, {std::nullopt, 20}, 1, Duration::zero(), 0};
    watch.score = {{0.5, std::nullopt}, {0.2, std::nullopt}, 1, Duration::zero(), 0};
    watch.deviation = {{std::nullopt, 0.3}, {std::nullopt, 1}, 1, Duration::zero(), 0};
    monitor_.Watch(watch);
  }
  Finding About(const std::string& subject, Time now) {
    for (const Finding& finding : monitor_.Report(processes_, {now, now})) {
      if (finding.subject == subject) return finding;
    }
    ADD_FAILURE() << "nothing about " << subject;
    return {};
  }
  LocalizationMonitor monitor_;
  ProcessTable processes_;
};

TEST_F(LocalizationMonitorTest, ARobotThatKnowsItsPlaceIsWell) {
  monitor_.OnState({LocalizationReading::Phase::kOk, 0.5, 0.9, 0.05, ""}, At(Time(seconds(1))));
  const auto findings = monitor_.Report(processes_, {Time(seconds(1)), Time(seconds(1))});
  ASSERT_EQ(findings.size(), 5u);
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.level, HealthLevel::kOk) << finding.subject;
    EXPECT_EQ(finding.node, "/localization");
  }
  EXPECT_EQ(findings[0].monitor, "localization");
  EXPECT_EQ(findings[4].monitor, "topic");
}

TEST_F(LocalizationMonitorTest, ThePhaseIsTheServersWord) {
  monitor_.OnState({LocalizationReading::Phase::kUncertain, 5, 0.9, 0.05, "many places"},
                   At(Time(seconds(1))));
  EXPECT_EQ(About("phase", Time(seconds(1))).level, HealthLevel::kWarn);
  EXPECT_EQ(About("phase", Time(seconds(1))).message, "uncertain: many places");
  monitor_.OnState({LocalizationReading::Phase::kLost, 5, 0.9, 0.05, ""}, At(Time(seconds(2))));
  EXPECT_EQ(About("phase", Time(seconds(2))).level, HealthLevel::kError);
  EXPECT_EQ(About("phase", Time(seconds(2))).message, "lost");
  monitor_.OnState({static_cast<LocalizationReading::Phase>(9), 5, 0.9, 0.05, ""},
                   At(Time(seconds(3))));
  EXPECT_EQ(About("phase", Time(seconds(3))).level, HealthLevel::kError);
}

TEST_F(LocalizationMonitorTest, TheNumbersAreJudgedEach) {
  monitor_.OnState({LocalizationReading::Phase::kOk, 15, 0.1, 0.5, ""}, At(Time(seconds(1))));
  EXPECT_EQ(About("since_confirmed", Time(seconds(1))).level, HealthLevel::kWarn);
  EXPECT_EQ(About("score", Time(seconds(1))).level, HealthLevel::kError);
  EXPECT_EQ(About("score", Time(seconds(1))).message, "0.1, expected at least 0.2");
  EXPECT_EQ(About("deviation", Time(seconds(1))).level, HealthLevel::kWarn);
  EXPECT_EQ(About("deviation", Time(seconds(1))).unit, "m");
}

TEST_F(LocalizationMonitorTest, SilenceIsAnErrorAndTheLastStateNoLongerBelieved) {
  monitor_.OnState({LocalizationReading::Phase::kLost, 15, 0.1, 0.5, ""}, At(Time(seconds(1))));
  EXPECT_EQ(About("/localization/state", Time(seconds(4))).level, HealthLevel::kOk);
  EXPECT_EQ(About("/localization/state", Time(seconds(5))).level, HealthLevel::kError);
  EXPECT_EQ(About("/localization/state", Time(seconds(5))).message, "no state for 4 s");
  EXPECT_EQ(About("phase", Time(seconds(5))).level, HealthLevel::kOk);
  EXPECT_EQ(About("phase", Time(seconds(5))).message, "state unknown");
  EXPECT_TRUE(std::isnan(About("score", Time(seconds(5))).value));
}

TEST_F(LocalizationMonitorTest, SilenceMustLastInWallTimeTooHoweverFastSimulatedTimeIs) {
  const auto level = [&](Time ros, Time wall) {
    return monitor_.Report(processes_, {ros, wall}).back().level;
  };
  monitor_.OnState({LocalizationReading::Phase::kOk, 0, 0.9, 0.05, ""},
                   {Time(seconds(100)), Time(seconds(10))});
  EXPECT_EQ(level(Time(seconds(118)), Time(seconds(13))), HealthLevel::kOk);
  EXPECT_EQ(level(Time(seconds(124)), Time(seconds(14))), HealthLevel::kError);
  monitor_.OnState({LocalizationReading::Phase::kOk, 0, 0.9, 0.05, ""},
                   {Time(seconds(125)), Time(seconds(15))});
  EXPECT_EQ(level(Time(seconds(126)), Time(seconds(25))),
            HealthLevel::kOk);  // simulated time is slow
}

TEST_F(LocalizationMonitorTest, SilenceFromTheBeginningIsNoticedAndAStartHasItsTime) {
  About("phase", Time(seconds(1)));
  EXPECT_EQ(About("/localization/state", Time(seconds(5))).level, HealthLevel::kError);
  processes_.by_node["/localization"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(About("/localization/state", Time(seconds(50))).level, HealthLevel::kOk);
  processes_.by_node["/localization"].phase = ProcessPhase::kReady;
  EXPECT_EQ(About("/localization/state", Time(seconds(53))).level, HealthLevel::kOk);
  EXPECT_EQ(About("/localization/state", Time(seconds(54))).level, HealthLevel::kError);
}

TEST_F(LocalizationMonitorTest, WithoutAWatchThereIsNothingToSay) {
  monitor_.Watch(std::nullopt);
  monitor_.OnState({LocalizationReading::Phase::kLost, 15, 0.1, 0.5, ""}, At(Time(seconds(1))));
  EXPECT_TRUE(monitor_.Report(processes_, {Time(seconds(1)), Time(seconds(1))}).empty());
}

}  // namespace
}  // namespace coppice::robot::monitoring
