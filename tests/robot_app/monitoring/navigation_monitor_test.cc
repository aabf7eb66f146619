#include "robot_app/monitoring/navigation_monitor.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

class NavigationMonitorTest : public testing::Test {
 protected:
  static constexpr Time kNow{seconds(100)};

  NavigationMonitorTest() {
    monitor_.Watch(NavigationWatch{"/navigation/state", "/navigation", seconds(20), seconds(5),
                                   seconds(3), seconds(15)});
  }
  void State(NavigationPhase phase, Duration in_phase, std::uint32_t failures = 0) {
    monitor_.OnState({phase, in_phase, failures, ""}, {kNow, kNow});
  }
  Finding Progress(Time now = kNow) { return monitor_.Report(processes_, {now, now}).at(0); }
  Finding Freshness(Time now = kNow) { return monitor_.Report(processes_, {now, now}).at(1); }

  NavigationMonitor monitor_;
  ProcessTable processes_;
};

TEST_F(NavigationMonitorTest, AnIdleOrDrivingRobotIsWellHoweverLong) {
  State(NavigationPhase::kIdle, seconds(100000), 3);
  EXPECT_EQ(Progress().level, HealthLevel::kOk);
  State(NavigationPhase::kDriving, seconds(100000));
  EXPECT_EQ(Progress().level, HealthLevel::kOk);
}

TEST_F(NavigationMonitorTest, AFailedGoalIsAFaultUntilItWouldHaveBeenTriedAgain) {
  State(NavigationPhase::kIdle, seconds(14), 1);
  EXPECT_EQ(Progress().level, HealthLevel::kError);
  State(NavigationPhase::kIdle, seconds(15), 1);
  EXPECT_EQ(Progress().level, HealthLevel::kOk);
}

TEST_F(NavigationMonitorTest, BlockedIsAWarningUpToItsBound) {
  State(NavigationPhase::kBlocked, seconds(20));
  EXPECT_EQ(Progress().level, HealthLevel::kWarn);
  EXPECT_EQ(Progress(kNow + milliseconds(1)).level, HealthLevel::kError);  // time goes on
  EXPECT_EQ(Progress().monitor, "navigation");
  EXPECT_EQ(Progress().node, "");  // a restart frees no corridor
  EXPECT_EQ(Progress().value, 20);
  EXPECT_EQ(Progress().message, "blocked for 20 s");
}

TEST_F(NavigationMonitorTest, NoPathIsAWarningUntilItLastsOrAGoalFails) {
  State(NavigationPhase::kNoPath, seconds(5));
  EXPECT_EQ(Progress().level, HealthLevel::kWarn);
  State(NavigationPhase::kNoPath, seconds(5) + milliseconds(1));
  EXPECT_EQ(Progress().level, HealthLevel::kError);
  State(NavigationPhase::kNoPath, seconds(0), 1);
  EXPECT_EQ(Progress().level, HealthLevel::kError);
}

TEST_F(NavigationMonitorTest, FailuresDoNotTurnAnObstacleOnTheWayIntoAnError) {
  State(NavigationPhase::kDriving, seconds(1), 2);
  State(NavigationPhase::kBlocked, seconds(1), 2);
  EXPECT_EQ(Progress().level, HealthLevel::kWarn);
}

// A pose that came late made a goal that had failed look as if it was driven to again.
TEST_F(NavigationMonitorTest, AFailedGoalIsAFaultWhileItsNextAttemptIsHeldUpAtOnce) {
  State(NavigationPhase::kDriving, seconds(1));
  State(NavigationPhase::kIdle, seconds(5), 1);
  State(NavigationPhase::kBlocked, seconds(1), 1);
  EXPECT_EQ(Progress().level, HealthLevel::kError);
  State(NavigationPhase::kDriving, seconds(0), 1);
  EXPECT_EQ(Progress().level, HealthLevel::kOk);
}

TEST_F(NavigationMonitorTest, OldNewsIsAnErrorOfTheTopicAndNamesTheNode) {
  State(NavigationPhase::kDriving, seconds(1));
  EXPECT_EQ(Freshness(kNow + seconds(3)).level, HealthLevel::kOk);
  const Finding stale = Freshness(kNow + seconds(3) + milliseconds(1));
  EXPECT_EQ(stale.level, HealthLevel::kError);
  EXPECT_EQ(stale.monitor, "topic");
  EXPECT_EQ(stale.subject, "/navigation/state");
  EXPECT_EQ(stale.node, "/navigation");
}

TEST_F(NavigationMonitorTest, AnOldObstacleIsNoNews) {
  State(NavigationPhase::kBlocked, seconds(19));
  EXPECT_EQ(Progress(kNow + seconds(4)).level, HealthLevel::kOk);
  EXPECT_EQ(Progress(kNow + seconds(4)).message, "state unknown");
}

TEST_F(NavigationMonitorTest, SilenceFromTheBeginningIsNoticed) {
  EXPECT_EQ(Freshness(kNow).level, HealthLevel::kOk);
  EXPECT_EQ(Freshness(kNow + seconds(4)).level, HealthLevel::kError);
}

TEST_F(NavigationMonitorTest, AServerThatStartsHasItsTime) {
  State(NavigationPhase::kNoPath, seconds(50));
  processes_.by_node["/navigation"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(Progress(kNow + seconds(60)).level, HealthLevel::kOk);  // forgotten with the server
  EXPECT_EQ(Freshness(kNow + seconds(60)).message, "starting");
  processes_.by_node["/navigation"].phase = ProcessPhase::kReady;
  EXPECT_EQ(Freshness(kNow + seconds(63)).level, HealthLevel::kOk);
  EXPECT_EQ(Freshness(kNow + seconds(64)).level, HealthLevel::kError);
}

TEST_F(NavigationMonitorTest, OldNewsMustLastInWallTimeToo) {
  NavigationMonitor patient(milliseconds(400));
  patient.Watch(NavigationWatch{"/navigation/state", "/navigation", {}, {}, seconds(3)});
  patient.Report(processes_, {kNow, Time(seconds(1))});
  const auto level = [&](Time wall) {
    return patient.Report(processes_, {kNow + seconds(30), wall}).at(1).level;
  };
  EXPECT_EQ(level(Time(seconds(4))), HealthLevel::kOk);
  EXPECT_EQ(level(Time(seconds(5))), HealthLevel::kWarn);
  EXPECT_EQ(level(Time(seconds(5) + milliseconds(400))), HealthLevel::kError);
}

TEST_F(NavigationMonitorTest, SaysNothingWhereNavigationIsNotWatched) {
  monitor_.Watch(std::nullopt);
  State(NavigationPhase::kNoPath, seconds(50));
  EXPECT_TRUE(monitor_.Report(processes_, {kNow, kNow}).empty());
}

TEST_F(NavigationMonitorTest, TimeThatJumpsBackMakesNothingStale) {
  State(NavigationPhase::kDriving, seconds(1));
  EXPECT_EQ(Freshness(Time(seconds(10))).level, HealthLevel::kOk);
  EXPECT_EQ(Freshness(Time(seconds(14))).level, HealthLevel::kError);
}

}  // namespace
}  // namespace coppice::robot::monitoring
