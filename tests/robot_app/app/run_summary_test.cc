#include "robot_app/app/run_summary.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "bt_core/record/recorder.h"
#include "tests/trees/tree_scenario.h"

namespace coppice::robot {
namespace {

using leaves::RecoveryCount;
using std::chrono::seconds;

// A recording that is written line by line.
class Script {
 public:
  NodeIndex Node(const std::string& path, const std::string& id = "Sequence") {
    DescribedNode node;
    node.path = path;
    node.id = id;
    recording_.tree.nodes.push_back(node);
    return static_cast<NodeIndex>(recording_.tree.nodes.size() - 1);
  }
  void Change(int second, NodeIndex node, Status from, Status to) {
    Tick(second);
    recording_.changes.push_back({Time(seconds(second)), {node, from, to}});
  }
  void Message(int second, NodeIndex node, const std::string& text) {
    Tick(second);
    recording_.messages.push_back({node, text});
  }
  // One activation from its first tick to its end.
  void Activation(int start, int end, NodeIndex node, Status result) {
    Change(start, node, Status::kIdle, Status::kRunning);
    Change(end, node, Status::kRunning, result);
    if (result != Status::kIdle) Change(end, node, result, Status::kIdle);
  }
  void Stay(int second, double x) {
    recording_.stays.push_back({Time(seconds(second)), {x, 0, 0}});
  }
  void Note(int second, const std::string& text) {
    recording_.notes.push_back({Time(seconds(second)), "note", text});
  }
  const RecordedEvents& recording() const { return recording_; }

 private:
  void Tick(int second) {
    recording_.end = Time(seconds(second));
    ++recording_.ticks;
  }
  RecordedEvents recording_;
};

class RunSummaryTest : public testing::Test {
 protected:
  RunSummary Summary() { return Summarize(application_.recording(), monitor_.recording()); }
  Script application_;
  Script monitor_;
};

TEST_F(RunSummaryTest, CountsCompletedRoundsAndStops) {
  const NodeIndex round = application_.Node("round");
  const NodeIndex stop = application_.Node("patrol_round/stop");
  application_.Activation(1, 5, stop, Status::kSuccess);
  application_.Activation(6, 9, stop, Status::kSuccess);
  application_.Activation(1, 9, round, Status::kSuccess);
  application_.Activation(10, 12, stop, Status::kIdle);
  EXPECT_EQ(Summary().rounds, 1);
  EXPECT_EQ(Summary().stops, 2);
  EXPECT_FALSE(Summary().docked);
}

TEST_F(RunSummaryTest, SeesThatTheRobotCameHome) {
  application_.Activation(1, 5, application_.Node("go_home"), Status::kSuccess);
  EXPECT_TRUE(Summary().docked);
}

TEST_F(RunSummaryTest, CountsARecoveryThatEndedWell) {
  monitor_.Activation(1, 5, monitor_.Node("as_published/restart_node/restart_nodes/restart"),
                      Status::kSuccess);
  const RecoveryCount count = Summary().Recovery("restart node");
  EXPECT_EQ(count.begun, 1);
  EXPECT_EQ(count.succeeded, 1);
  EXPECT_EQ(count.helped, 1);
}

TEST_F(RunSummaryTest, CountsARecoveryThatFailedOrWasPreEmpted) {
  const NodeIndex wait =
      monitor_.Node("as_published/recover_navigation/free_navigation/wait_and_retry");
  monitor_.Activation(1, 5, wait, Status::kFailure);
  monitor_.Activation(6, 8, wait, Status::kIdle);
  const RecoveryCount count = Summary().Recovery("wait and retry");
  EXPECT_EQ(count.begun, 2);
  EXPECT_EQ(count.succeeded, 0);
}

// The definition is that of the judge (recovery_judge.h); here the record is its witness.
TEST_F(RunSummaryTest, JudgesByTimeAndByThePlaceThatTheTreeKnew) {
  const NodeIndex wait =
      monitor_.Node("as_published/recover_navigation/free_navigation/wait_and_retry");
  monitor_.Stay(0, 0);
  monitor_.Activation(0, 20, wait, Status::kSuccess);
  monitor_.Stay(40, 5);
  monitor_.Activation(50, 70, wait, Status::kSuccess);  // soon, but elsewhere
  monitor_.Activation(80, 90, wait, Status::kSuccess);  // soon, and there
  const RecoveryCount count = Summary().Recovery("wait and retry");
  EXPECT_EQ(count.helped, 2);
  EXPECT_EQ(count.helped_strictly, 1);
}

TEST_F(RunSummaryTest, ARecoveryOfAnotherFaultSpeaksAgainstNone) {
  monitor_.Activation(0, 10, monitor_.Node("as_published/restart_node/restart_nodes/restart"),
                      Status::kSuccess);
  monitor_.Activation(
      20, 30, monitor_.Node("as_published/recover_navigation/free_navigation/wait_and_retry"),
      Status::kSuccess);
  EXPECT_EQ(Summary().Recovery("restart node").helped, 1);
}

TEST_F(RunSummaryTest, GivesZerosForARecoveryThatThereIsNot) {
  EXPECT_EQ(Summary().Recovery("dance").begun, 0);
}

TEST_F(RunSummaryTest, ListsInjectedFaultsAndWhatTheMonitorsSawOnce) {
  const NodeIndex fault = monitor_.Node("node_error", "NodeFault");
  const NodeIndex other = monitor_.Node("restart", "RestartNode");
  monitor_.Note(1, "fault injected: kill_node /a");
  monitor_.Note(1, "something else");
  monitor_.Message(2, fault, "/a: does not answer");
  monitor_.Message(3, fault, "/a: does not answer");
  monitor_.Message(4, other, "refused");
  EXPECT_EQ(Summary().injected, std::vector<std::string>{"fault injected: kill_node /a"});
  EXPECT_EQ(Summary().faults, std::vector<std::string>{"/a: does not answer"});
}

TEST_F(RunSummaryTest, CountsTicksAndTime) {
  const NodeIndex node = application_.Node("a");
  application_.Change(0, node, Status::kIdle, Status::kRunning);
  application_.Change(30, node, Status::kRunning, Status::kSuccess);
  EXPECT_EQ(Summary().application.ticks, 2u);
  EXPECT_EQ(Summary().application.status_changes, 2u);
  EXPECT_DOUBLE_EQ(Summary().application.seconds, 30);
}

TEST_F(RunSummaryTest, PrintsOnlyTheRecoveriesThatHappened) {
  monitor_.Activation(1, 5, monitor_.Node("as_published/restart_node/restart_nodes/restart"),
                      Status::kSuccess);
  const std::string table = ToTable(Summary(), 12.3);
  EXPECT_NE(table.find("restart node"), std::string::npos);
  EXPECT_EQ(table.find("slow rotate"), std::string::npos);
  EXPECT_NE(table.find("12.3 m"), std::string::npos);
}

// The way is blocked for 19 s at that place [m], then it is free.
void BlockTheWay(TreeScenario& scenario, double x) {
  scenario.Set("pose", leaves::Pose2D{x, 0, 0});
  for (int i = 0; i < 44; ++i) {
    scenario.Advance(0.5);
    if (i < 38) scenario.Report({{"navigation", "path"}});
    if (i >= 38) scenario.Report();
    scenario.Tick();
  }
}

TEST(SummarizeFiles, FindsRecoveriesAndPlacesInARecordOfTheShippedMonitorTree) {
  const std::string file =
      testing::TempDir() + "run_summary_" + std::to_string(getpid()) + ".coppice";
  {
    TreeScenario scenario("monitor/monitor.xml");
    EventStream stream(scenario.executor());
    Recorder recorder(stream, file);
    BlockTheWay(scenario, 0);
    BlockTheWay(scenario, 5);
    EXPECT_EQ(recorder.Close().problem(), "");
  }
  const RunSummary summary = SummarizeFiles(file, file);
  std::remove(file.c_str());
  EXPECT_EQ(summary.problems, std::vector<std::string>{});
  const RecoveryCount count = summary.Recovery("wait and retry");
  EXPECT_EQ(count.begun, 2);
  EXPECT_EQ(count.succeeded, 2);
  EXPECT_EQ(count.helped, 2) << "the second was elsewhere";
  EXPECT_EQ(count.helped_strictly, 1) << "but soon";
}

TEST(SummarizeFiles, SaysWhichRecordIsMissing) {
  const RunSummary summary = SummarizeFiles("/no/application.coppice", "/no/monitor.coppice");
  ASSERT_EQ(summary.problems.size(), 2u);
  EXPECT_NE(summary.problems[0].find("/no/application.coppice"), std::string::npos);
}

}  // namespace
}  // namespace coppice::robot
