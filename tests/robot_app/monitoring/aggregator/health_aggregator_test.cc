#include "robot_app/monitoring/aggregator/health_aggregator.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

Finding About(const std::string& subject, HealthLevel level) {
  return {"node", subject, subject, level, 0, "", "", Time{}};
}

class HealthAggregatorTest : public testing::Test {
 protected:
  HealthAggregatorTest() { aggregator_.Expect({{"/monitor", milliseconds(500)}}, now_); }

  bool Report(HealthLevel level) {
    return aggregator_.OnReport("/monitor", {About("/a", level)}, now_);
  }
  bool CheckSilence() { return aggregator_.CheckSilence(processes_, now_, Time(Duration(9))); }
  std::vector<Finding> Publish() { return aggregator_.Publish(now_, Time(Duration(9))); }
  HealthLevel Published() { return Publish().at(0).level; }

  HealthAggregator aggregator_{milliseconds(250), 3};
  ProcessTable processes_;
  Time now_{seconds(100)};
};

TEST_F(HealthAggregatorTest, AnErrorThatWasGoneBeforeThePublicationIsSeenNevertheless) {
  Report(HealthLevel::kError);
  now_ += seconds(10);
  Report(HealthLevel::kOk);
  EXPECT_EQ(Published(), HealthLevel::kError);
  EXPECT_EQ(Published(), HealthLevel::kOk);
}

TEST_F(HealthAggregatorTest, TheWorstOfSeveralReportsCounts) {
  Report(HealthLevel::kWarn);
  Report(HealthLevel::kError);
  Report(HealthLevel::kWarn);
  now_ += seconds(1);
  EXPECT_EQ(Published(), HealthLevel::kError);
  EXPECT_EQ(Published(), HealthLevel::kWarn);
}

TEST_F(HealthAggregatorTest, ABadLevelIsHeldForSlowReaders) {
  Report(HealthLevel::kError);
  EXPECT_EQ(Published(), HealthLevel::kError);
  Report(HealthLevel::kOk);
  now_ += milliseconds(249);
  EXPECT_EQ(Published(), HealthLevel::kError);
  now_ += milliseconds(1);
  EXPECT_EQ(Published(), HealthLevel::kOk);
}

TEST_F(HealthAggregatorTest, OnlyAChangeOfLevelIsUrgent) {
  EXPECT_TRUE(Report(HealthLevel::kOk));  // the first word about it
  Published();
  EXPECT_FALSE(Report(HealthLevel::kOk));
  EXPECT_TRUE(Report(HealthLevel::kWarn));
  EXPECT_TRUE(Report(HealthLevel::kWarn));  // not yet published
  Published();
  EXPECT_FALSE(Report(HealthLevel::kWarn));
  EXPECT_TRUE(Report(HealthLevel::kOk));
}

TEST_F(HealthAggregatorTest, ASilentSourceMakesItsEntriesStale) {
  aggregator_.OnReport("/monitor",
                       {About("/a", HealthLevel::kOk), About("/b", HealthLevel::kError)}, now_);
  Publish();
  now_ += milliseconds(1500);
  EXPECT_FALSE(CheckSilence());  // three periods exactly
  now_ += milliseconds(1);
  EXPECT_TRUE(CheckSilence());
  EXPECT_FALSE(CheckSilence());  // no longer news
  const auto findings = Publish();
  ASSERT_EQ(findings.size(), 3u);
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.level, HealthLevel::kStale);
    EXPECT_EQ(finding.node, "/monitor");  // the monitor is to be restarted, not what it watched
    EXPECT_EQ(finding.message, "/monitor: no report for 1.5 s");
    EXPECT_EQ(finding.stamp, Time(Duration(9)));
  }
  EXPECT_EQ(findings[2].monitor, "node");
  EXPECT_EQ(findings[2].subject, "/monitor");
}

TEST_F(HealthAggregatorTest, ASourceThatNeverSpokeIsSilentToo) {
  now_ += seconds(2);
  EXPECT_TRUE(CheckSilence());
  EXPECT_EQ(Published(), HealthLevel::kStale);
}

TEST_F(HealthAggregatorTest, ASourceThatSpeaksAgainIsBelieved) {
  Report(HealthLevel::kOk);
  now_ += seconds(2);
  CheckSilence();
  Publish();
  now_ += seconds(1);
  EXPECT_TRUE(Report(HealthLevel::kOk));
  EXPECT_FALSE(CheckSilence());
  const auto findings = Publish();
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].level, HealthLevel::kOk);
  EXPECT_EQ(findings[0].node, "/a");
}

TEST_F(HealthAggregatorTest, ASourceThatIsBeingStartedHasItsTime) {
  Report(HealthLevel::kError);
  now_ += seconds(2);
  CheckSilence();
  processes_.by_node["/monitor"].phase = ProcessPhase::kStarting;
  EXPECT_TRUE(CheckSilence());
  EXPECT_TRUE(Publish().empty());  // its old entries are gone with it
  now_ += seconds(60);
  EXPECT_FALSE(CheckSilence());
  processes_.by_node["/monitor"].phase = ProcessPhase::kReady;
  now_ += milliseconds(1500);
  EXPECT_FALSE(CheckSilence());
  now_ += milliseconds(1);
  EXPECT_TRUE(CheckSilence());
}

TEST_F(HealthAggregatorTest, UnknownSourcesArePassedThroughAndNamed) {
  aggregator_.OnReport("/stranger", {About("/x", HealthLevel::kOk)}, now_);
  const auto findings = Publish();
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].subject, "/x");
  EXPECT_EQ(findings[0].level, HealthLevel::kOk);
  EXPECT_EQ(findings[1].monitor, "aggregation");
  EXPECT_EQ(findings[1].subject, "/stranger");
  EXPECT_EQ(findings[1].level, HealthLevel::kWarn);
  EXPECT_EQ(findings[1].stamp, Time(Duration(9)));
}

TEST_F(HealthAggregatorTest, AnUnknownSourceThatFallsSilentIsRestartedByNobodyAndForgotten) {
  aggregator_.Expect({}, now_);
  aggregator_.OnReport("/stranger", {About("/x", HealthLevel::kError)}, now_);
  now_ += seconds(7);
  CheckSilence();
  for (const Finding& finding : Publish()) {
    EXPECT_EQ(finding.node, "");
    EXPECT_EQ(finding.level,
              finding.monitor == "aggregation" ? HealthLevel::kWarn : HealthLevel::kStale);
  }
  EXPECT_EQ(Publish().size(), 3u);
  now_ += seconds(60);
  CheckSilence();
  EXPECT_TRUE(Publish().empty());
}

TEST_F(HealthAggregatorTest, SourcesThatAreNoLongerExpectedAreForgotten) {
  Report(HealthLevel::kError);
  aggregator_.OnReport("/stranger", {About("/x", HealthLevel::kOk)}, now_);
  aggregator_.Expect({{"/other", milliseconds(500)}}, now_);
  const auto findings = Publish();
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].subject, "/x");
}

// The monitors that a configuration does not need end a moment after it has come into force.
TEST_F(HealthAggregatorTest, TheLastWordsOfADismissedSourceAreIgnored) {
  Report(HealthLevel::kOk);
  aggregator_.Expect({}, now_);
  now_ += seconds(1);
  EXPECT_FALSE(Report(HealthLevel::kError));
  now_ += seconds(30);
  CheckSilence();
  EXPECT_TRUE(Publish().empty());
  Report(HealthLevel::kOk);  // it goes on: now it is a stranger
  EXPECT_EQ(Publish().size(), 2u);
  aggregator_.Expect({{"/monitor", milliseconds(500)}}, now_);
  EXPECT_EQ(Publish().size(), 1u);
}

TEST_F(HealthAggregatorTest, ADismissedSourceThatIsExpectedAgainHasItsTime) {
  Report(HealthLevel::kOk);
  aggregator_.Expect({}, now_);
  now_ += seconds(20);
  aggregator_.Expect({{"/monitor", milliseconds(500)}}, now_);
  now_ += seconds(1);
  EXPECT_FALSE(CheckSilence());
  now_ += seconds(1);
  EXPECT_TRUE(CheckSilence());
}

TEST_F(HealthAggregatorTest, ASilentSourceOfAnotherComputerNamesIt) {
  aggregator_.Expect({{"/jetson_system_monitor", milliseconds(500), "jetson"}}, now_);
  now_ += seconds(2);
  CheckSilence();
  EXPECT_EQ(Publish().at(0).host, "jetson");
}

TEST_F(HealthAggregatorTest, WhatAReportNoLongerMentionsIsForgotten) {
  Report(HealthLevel::kOk);
  Publish();
  EXPECT_TRUE(aggregator_.OnReport("/monitor", {}, now_));
  EXPECT_TRUE(Publish().empty());
}

TEST_F(HealthAggregatorTest, TheSameSubjectFromTwoSourcesIsTwoEntries) {
  Report(HealthLevel::kOk);
  aggregator_.OnReport("/stranger", {About("/a", HealthLevel::kError)}, now_);
  EXPECT_EQ(Publish().size(), 3u);  // and the one about the stranger
}

}  // namespace
}  // namespace coppice::robot::monitoring
