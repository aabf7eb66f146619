#include "robot_app/monitoring/aggregator/health_messages.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

class HealthMessagesTest : public testing::Test {
 protected:
  HealthMessagesTest() { ros::Time::init(); }
};

TEST_F(HealthMessagesTest, AFindingSurvivesTheJourney) {
  const Finding finding{"topic", "/scan", "/scanner", HealthLevel::kWarn,
                        7.5,     "Hz",    "slow",     Time(Duration(1500000000)),
                        "jetson"};
  const coppice_msgs::Health message = ToMessage("/topic_monitor", {finding});
  EXPECT_EQ(message.source, "/topic_monitor");
  EXPECT_FALSE(message.header.stamp.isZero());
  const auto findings = FromMessage(message);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].monitor, "topic");
  EXPECT_EQ(findings[0].subject, "/scan");
  EXPECT_EQ(findings[0].node, "/scanner");
  EXPECT_EQ(findings[0].level, HealthLevel::kWarn);
  EXPECT_EQ(findings[0].value, 7.5);
  EXPECT_EQ(findings[0].unit, "Hz");
  EXPECT_EQ(findings[0].message, "slow");
  EXPECT_EQ(findings[0].stamp, Time(Duration(1500000000)));
  EXPECT_EQ(findings[0].host, "jetson");
}

TEST_F(HealthMessagesTest, TheNumbersOfLevelsAndPhasesAreThoseOfTheMessages) {
  using Entry = coppice_msgs::HealthEntry;
  using State = coppice_msgs::ProcessState;
  EXPECT_EQ(static_cast<int>(HealthLevel::kOk), +Entry::OK);
  EXPECT_EQ(static_cast<int>(HealthLevel::kWarn), +Entry::WARN);
  EXPECT_EQ(static_cast<int>(HealthLevel::kError), +Entry::ERROR);
  EXPECT_EQ(static_cast<int>(HealthLevel::kStale), +Entry::STALE);
  EXPECT_EQ(static_cast<int>(ProcessPhase::kStopped), +State::STOPPED);
  EXPECT_EQ(static_cast<int>(ProcessPhase::kStarting), +State::STARTING);
  EXPECT_EQ(static_cast<int>(ProcessPhase::kReady), +State::READY);
  EXPECT_EQ(static_cast<int>(ProcessPhase::kBackingOff), +State::BACKING_OFF);
  EXPECT_EQ(static_cast<int>(ProcessPhase::kGivenUp), +State::GIVEN_UP);
}

TEST_F(HealthMessagesTest, AnUnknownLevelIsTakenForTheWorst) {
  coppice_msgs::Health message;
  message.entries.resize(1);
  message.entries[0].level = 77;
  EXPECT_EQ(FromMessage(message).at(0).level, HealthLevel::kStale);
}

TEST_F(HealthMessagesTest, ProcessesAreFoundByTheirNodes) {
  coppice_msgs::ProcessStates message;
  message.configuration = "charging";
  message.processes.resize(2);
  message.processes[0].node = "/a";
  message.processes[0].state = coppice_msgs::ProcessState::STARTING;
  message.processes[0].message = "waits for b";
  message.processes[0].host = "jetson";
  const ProcessTable table = FromMessage(message);
  EXPECT_EQ(table.configuration, "charging");
  EXPECT_EQ(table.HostOf("/a"), "jetson");
  EXPECT_EQ(table.HostOf("/unknown"), "");
  ASSERT_EQ(table.by_node.size(), 1u);  // the other one has no node
  EXPECT_TRUE(table.IsStarting("/a"));
  EXPECT_EQ(table.by_node.at("/a").message, "waits for b");
}

}  // namespace
}  // namespace coppice::robot::monitoring
