// The monitor tree: what is done about a fault, and which fault comes first.
#include <gtest/gtest.h>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

class MonitorTree : public testing::Test {
 protected:
  MonitorTree() {
    scenario_.Set("charging", false);
    scenario_.Set("configuration", std::string("operating"));
  }
  TreeScenario scenario_{"monitor/monitor.xml"};
};

// Stuede et al. 2021: "The composition of the tree defines the priority of error handling."
TEST_F(MonitorTree, HasTheStructureOfThePaper) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(scenario_.ChildrenOf("monitor"),
            (Names{"check_and_set_configuration", "process_monitors", "handle_errors"}));
  EXPECT_EQ(scenario_.ChildrenOf("handle_errors"),
            (Names{"node_or_topic", "navigation", "localization", "all_well"}));
  EXPECT_EQ(scenario_.ChildrenOf("node_or_topic"), (Names{"node_or_topic_error", "restart_node"}));
  EXPECT_EQ(scenario_.ChildrenOf("node_or_topic_error"), (Names{"node_error", "topic_error"}));
  EXPECT_EQ(scenario_.ChildrenOf("navigation"), (Names{"navigation_error", "recover_navigation"}));
  EXPECT_EQ(scenario_.ChildrenOf("localization"),
            (Names{"localization_error", "recover_localization"}));
}

TEST_F(MonitorTree, DoesNothingWhenAllIsWell) {
  scenario_.Report();
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_TRUE(scenario_.robot.calls.empty());
}

TEST_F(MonitorTree, RestartsANodeThatDoesNotAnswer) {
  scenario_.Report({{"node", "/navigation"}});
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /navigation");
}

TEST_F(MonitorTree, RestartsTheNodeThatPublishesASilentTopic) {
  scenario_.Report({{"topic", "/simulator"}});
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /simulator");
}

TEST_F(MonitorTree, IsDoneWithANodeWhenNobodyBlamesItAnyMore) {
  scenario_.Report({{"node", "/navigation"}});
  scenario_.Tick();
  EXPECT_EQ(scenario_.Answer(true), Status::kRunning);
  scenario_.Report();
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_EQ(scenario_.CallsOf("RestartNode /navigation"), 1);
}

TEST_F(MonitorTree, AsksAPersonWhenTheRestartIsRefused) {
  scenario_.Report({{"node", "/navigation"}});
  scenario_.Tick();
  scenario_.Answer(false);
  EXPECT_EQ(scenario_.LastCall().rfind("Ask ", 0), 0u);
}

TEST_F(MonitorTree, GivesADeadNodePriorityOverARunningRecoveryOfTheNavigation) {
  scenario_.Report({{"navigation", "path"}});
  scenario_.Tick();
  ASSERT_EQ(scenario_.StatusOf("wait_and_retry"), Status::kRunning);
  scenario_.Report({{"navigation", "path"}, {"node", "/docking"}});
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /docking");
  EXPECT_EQ(scenario_.StatusOf("wait_and_retry"), Status::kIdle);
}

TEST_F(MonitorTree, WithdrawsAQuestionThatSettlesItselfBehindAMoreUrgentFault) {
  scenario_.Report({{"navigation", "path"}});
  scenario_.Tick();
  scenario_.Advance(20);
  scenario_.Report({{"navigation", "path"}});
  scenario_.Tick();
  scenario_.Answer(true);
  scenario_.Advance(20);
  scenario_.Report({{"navigation", "path"}});
  scenario_.Tick();
  ASSERT_EQ(scenario_.LastCall().rfind("Ask ", 0), 0u);
  scenario_.Report({{"navigation", "path"}, {"node", "/docking"}});
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("Withdraw navigation"), 1);
}

TEST_F(MonitorTree, RepairsNothingWithoutReports) {
  EXPECT_EQ(scenario_.Tick(), Status::kFailure);
  EXPECT_TRUE(scenario_.robot.calls.empty());
}

TEST_F(MonitorTree, RepairsNothingOnOldReports) {
  scenario_.Report({{"node", "/navigation"}});
  scenario_.Advance(60);
  EXPECT_EQ(scenario_.Tick(), Status::kFailure);
  EXPECT_TRUE(scenario_.robot.calls.empty());
}

TEST_F(MonitorTree, SwitchesToChargingWhenCurrentFlows) {
  scenario_.Set("charging", true);
  scenario_.Report();
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "SetConfiguration charging");
}

TEST_F(MonitorTree, SwitchesBackToOperatingWhenCurrentStops) {
  scenario_.Set("configuration", std::string("charging"));
  scenario_.Report();
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "SetConfiguration operating");
}

TEST(MonitorTreeWithoutBattery, KeepsTheConfigurationAndWatchesTheRest) {
  TreeScenario scenario("monitor/monitor.xml");
  scenario.Set("configuration", std::string("charging"));
  scenario.Report({{"node", "/docking"}});
  scenario.Tick();
  EXPECT_EQ(scenario.robot.calls, std::vector<std::string>{"RestartNode /docking"});
}

TEST_F(MonitorTree, ChecksTheConfigurationBeforeTheMonitors) {
  scenario_.Set("configuration", std::string("charging"));
  scenario_.Report({{"node", "/navigation"}});
  scenario_.Tick();
  EXPECT_EQ(scenario_.robot.calls,
            (std::vector<std::string>{"SetConfiguration operating", "RestartNode /navigation"}));
}

}  // namespace
}  // namespace coppice
