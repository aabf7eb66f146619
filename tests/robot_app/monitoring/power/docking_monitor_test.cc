#include "robot_app/monitoring/power/docking_monitor.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

class DockingMonitorTest : public testing::Test {
 protected:
  DockingMonitorTest() {
    DockingWatch watch;
    watch.action = "/docking";
    watch.node = "/docking";
    watch.staleness = seconds(5);
    watch.failures = {{std::nullopt, 0}, {std::nullopt, 2}, 1, Duration::zero(), 0};
    watch.duration = {{std::nullopt, 100}, {std::nullopt, 200}, 1, Duration::zero(), 0};
    watch.forget = seconds(600);
    monitor_.Watch(watch);
  }
  void Tell(const std::string& id, GoalPhase phase) {
    now_ += seconds(1);
    monitor_.OnGoals({{id, phase, "no current"}}, {now_, now_});
  }
  void Attempt(const std::string& id, GoalPhase end) {
    Tell(id, GoalPhase::kActive);
    monitor_.OnProgress(id, 0, "", now_);
    Tell(id, end);
    Tell(id, end);  // servers go on telling it for a while
  }
  Finding About(const std::string& subject) {
    for (const Finding& finding : monitor_.Report(processes_, {now_, now_})) {
      if (finding.subject == subject) return finding;
    }
    ADD_FAILURE() << "nothing about " << subject;
    return {};
  }

  DockingMonitor monitor_;
  ProcessTable processes_;
  Time now_{seconds(1000)};
};

TEST_F(DockingMonitorTest, AServerWithoutGoalsIsWell) {
  monitor_.OnGoals({}, {now_, now_});
  for (const Finding& finding : monitor_.Report(processes_, {now_, now_})) {
    EXPECT_EQ(finding.level, HealthLevel::kOk) << finding.subject;
    EXPECT_EQ(finding.monitor, "docking");
  }
}

TEST_F(DockingMonitorTest, FailuresInARowBecomeAnError) {
  Attempt("1", GoalPhase::kAborted);
  EXPECT_EQ(About("failures").level, HealthLevel::kWarn);
  Attempt("2", GoalPhase::kRejected);
  EXPECT_EQ(About("failures").value, 2);
  EXPECT_EQ(About("failures").level, HealthLevel::kWarn);
  Attempt("3", GoalPhase::kAborted);
  EXPECT_EQ(About("failures").level, HealthLevel::kError);
  EXPECT_EQ(About("failures").message, "3 in a row: no current");
  Attempt("4", GoalPhase::kSucceeded);
  EXPECT_EQ(About("failures").level, HealthLevel::kOk);
  EXPECT_EQ(About("failures").message, "");
}

TEST_F(DockingMonitorTest, TheAttemptsOfOneGoalCountWhileItIsUnderWay) {
  Attempt("0", GoalPhase::kAborted);
  Tell("1", GoalPhase::kActive);
  EXPECT_EQ(About("failures").value, 1);
  monitor_.OnProgress("1", 0, "", now_);
  monitor_.OnProgress("1", 1, "missed", now_);
  monitor_.OnProgress("1", 1, "missed", now_);
  EXPECT_EQ(About("failures").level, HealthLevel::kWarn);
  EXPECT_EQ(About("failures").message, "2 in a row: missed");
  monitor_.OnProgress("1", 2, "missed", now_);
  EXPECT_EQ(About("failures").level, HealthLevel::kError);
  Tell("1", GoalPhase::kAborted);
  EXPECT_EQ(About("failures").value, 3);  // its end is no further attempt
  monitor_.OnProgress("1", 5, "late news", now_);
  EXPECT_EQ(About("failures").value, 3);
  Tell("2", GoalPhase::kActive);
  monitor_.OnProgress("2", 1, "missed", now_);
  Tell("2", GoalPhase::kSucceeded);
  EXPECT_EQ(About("failures").level, HealthLevel::kOk);
}

TEST_F(DockingMonitorTest, AnEndThatWasSeenWithoutItsBeginningCounts) {
  monitor_.OnProgress("quick", 0, "", now_);
  Tell("quick", GoalPhase::kAborted);
  EXPECT_EQ(About("failures").value, 1);
}

TEST_F(DockingMonitorTest, AGoalForWhichNothingWasDoneCountsNeitherWay) {
  Attempt("1", GoalPhase::kAborted);
  Tell("2", GoalPhase::kActive);
  Tell("2", GoalPhase::kAborted);
  EXPECT_EQ(About("failures").value, 1);
}

TEST_F(DockingMonitorTest, ACancelledAttemptCountsNeitherWay) {
  Attempt("1", GoalPhase::kAborted);
  Attempt("2", GoalPhase::kPreempted);
  EXPECT_EQ(About("failures").value, 1);
}

TEST_F(DockingMonitorTest, OldFailuresAreForgotten) {
  for (const char* id : {"1", "2", "3"}) Attempt(id, GoalPhase::kAborted);
  now_ += seconds(590);
  EXPECT_EQ(About("failures").level, HealthLevel::kError);
  now_ += seconds(20);
  EXPECT_EQ(About("failures").level, HealthLevel::kOk);
}

TEST_F(DockingMonitorTest, AnAttemptMustNotLastTooLong) {
  Tell("1", GoalPhase::kPending);
  now_ += seconds(500);
  EXPECT_EQ(About("duration").value, 0);
  Tell("1", GoalPhase::kActive);
  now_ += seconds(150);
  EXPECT_EQ(About("duration").level, HealthLevel::kWarn);
  Tell("1", GoalPhase::kPreempting);
  now_ += seconds(60);
  EXPECT_EQ(About("duration").level, HealthLevel::kError);
  Tell("1", GoalPhase::kPreempted);
  EXPECT_EQ(About("duration").level, HealthLevel::kOk);
}

TEST_F(DockingMonitorTest, ASilentServerIsAnErrorOfItsNode) {
  About("state");
  now_ += seconds(5);
  EXPECT_EQ(About("state").level, HealthLevel::kOk);
  now_ += milliseconds(1);
  EXPECT_EQ(About("state").level, HealthLevel::kError);
  EXPECT_EQ(About("state").node, "/docking");
  processes_.by_node["/docking"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(About("state").level, HealthLevel::kOk);
}

TEST_F(DockingMonitorTest, WithoutAWatchThereIsNothingToSay) {
  monitor_.Watch(std::nullopt);
  Tell("1", GoalPhase::kAborted);
  EXPECT_TRUE(monitor_.Report(processes_, {now_, now_}).empty());
}

}  // namespace
}  // namespace coppice::robot::monitoring
