#include "robot_app/monitoring/node_monitor.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

ProbeResult Answer() { return {true, 7, std::chrono::milliseconds(2), ""}; }
ProbeResult Silence() { return {false, 0, Duration::zero(), "does not answer"}; }

class NodeMonitorTest : public testing::Test {
 protected:
  NodeMonitorTest() { monitor_.Watch({{"/a", 2}, {"/b", 1}}); }
  Finding Of(std::size_t index) {
    return monitor_.Report(processes_, {Time(Duration(5)), {}}).at(index);
  }

  NodeMonitor monitor_;
  ProcessTable processes_;
};

TEST_F(NodeMonitorTest, AsksForTheWatchedNodes) {
  ASSERT_EQ(monitor_.Requests().size(), 2u);
  EXPECT_EQ(monitor_.Requests()[1].node, "/b");
}

TEST_F(NodeMonitorTest, ANodeThatAnswersIsWell) {
  monitor_.Observe("/a", Answer());
  EXPECT_EQ(Of(0).level, HealthLevel::kOk);
  EXPECT_EQ(Of(0).monitor, "node");
  EXPECT_EQ(Of(0).subject, "/a");
  EXPECT_EQ(Of(0).node, "/a");
  EXPECT_DOUBLE_EQ(Of(0).value, 0.002);
  EXPECT_EQ(Of(0).stamp, Time(Duration(5)));
}

TEST_F(NodeMonitorTest, OnlyMissesInARowAreAnError) {
  monitor_.Observe("/a", Silence());
  EXPECT_EQ(Of(0).level, HealthLevel::kWarn);
  monitor_.Observe("/a", Answer());
  monitor_.Observe("/a", Silence());
  EXPECT_EQ(Of(0).level, HealthLevel::kWarn);
  monitor_.Observe("/a", Silence());
  EXPECT_EQ(Of(0).level, HealthLevel::kError);
  EXPECT_EQ(Of(0).message, "does not answer (2 pings in a row)");
  monitor_.Observe("/a", Answer());
  EXPECT_EQ(Of(0).level, HealthLevel::kOk);
  monitor_.Observe("/b", Silence());
  EXPECT_EQ(Of(1).level, HealthLevel::kError);  // its limit is one
}

TEST_F(NodeMonitorTest, MissesDuringTheStartAreForgotten) {
  monitor_.Observe("/a", Silence());
  monitor_.Observe("/a", Silence());
  processes_.by_node["/a"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(Of(0).level, HealthLevel::kOk);
  EXPECT_EQ(Of(0).message, "starting");
  processes_.by_node["/a"].phase = ProcessPhase::kReady;
  monitor_.Observe("/a", Silence());
  EXPECT_EQ(Of(0).level, HealthLevel::kWarn);
}

TEST_F(NodeMonitorTest, AChangeOfTheListKeepsWhatIsKnownAndIgnoresOthers) {
  monitor_.Observe("/a", Silence());
  monitor_.Observe("/a", Silence());
  monitor_.Watch({{"/c", 2}, {"/a", 2}});
  monitor_.Observe("/b", Silence());
  EXPECT_EQ(Of(0).level, HealthLevel::kOk);
  EXPECT_EQ(Of(1).level, HealthLevel::kError);
  EXPECT_EQ(monitor_.Report(processes_, {}).size(), 2u);
}

}  // namespace
}  // namespace coppice::robot::monitoring
