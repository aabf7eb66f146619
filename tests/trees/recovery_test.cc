// The ladders of the recovery trees, each run alone.
#include <gtest/gtest.h>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

Health Errors(const std::string& monitor) {
  Health health;
  if (!monitor.empty()) {
    health.entries.push_back({monitor, "it", "/it", HealthLevel::kError, "broken"});
  }
  return health;
}

class RecoverNavigation : public testing::Test {
 protected:
  RecoverNavigation() { scenario_.Set("health", Errors("navigation")); }
  TreeScenario scenario_{"recovery/recover_navigation.xml"};
};

TEST_F(RecoverNavigation, WaitsFirst) {
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.StatusOf("wait_and_retry"), Status::kRunning);
  EXPECT_TRUE(scenario_.robot.calls.empty());
}

TEST_F(RecoverNavigation, IsDoneWhenTheFaultIsGoneAfterTheWait) {
  scenario_.Tick();
  scenario_.Set("health", Errors(""));
  scenario_.Advance(20);
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
}

TEST_F(RecoverNavigation, MovesBackwardsWhenWaitingDoesNotHelp) {
  scenario_.Tick();
  scenario_.Advance(20);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "Move -0.3 0.1");
}

TEST_F(RecoverNavigation, AsksAPersonWhenNeitherHelps) {
  scenario_.Tick();
  scenario_.Advance(20);
  scenario_.Tick();
  scenario_.Answer(true);
  scenario_.Advance(20);
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall().rfind("Ask ", 0), 0u);
}

TEST_F(RecoverNavigation, AsksAPersonWhenItCannotMoveBackwards) {
  scenario_.Tick();
  scenario_.Advance(20);
  scenario_.Tick();
  scenario_.Answer(false);
  EXPECT_EQ(scenario_.LastCall().rfind("Ask ", 0), 0u);
}

TEST_F(RecoverNavigation, GivesUpWhenNobodyAnswers) {
  scenario_.Tick();
  scenario_.Advance(20);
  scenario_.Tick();
  scenario_.Answer(false);
  scenario_.Advance(600);
  EXPECT_EQ(scenario_.Tick(), Status::kFailure);
  EXPECT_EQ(scenario_.LastCall(), "Withdraw navigation");
}

TEST_F(RecoverNavigation, WithdrawsTheQuestionWhenTheWayIsFreeAgain) {
  scenario_.Tick();
  scenario_.Advance(20);
  scenario_.Tick();
  scenario_.Answer(false);
  ASSERT_EQ(scenario_.LastCall().rfind("Ask ", 0), 0u);
  scenario_.Set("health", Errors(""));
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_EQ(scenario_.LastCall(), "Withdraw navigation");
}

TEST(RestartFaultyNode, WithdrawsTheQuestionWhenTheNodeIsWellAgain) {
  TreeScenario scenario("recovery/restart_node.xml");
  scenario.Set("health", Errors("node"));
  scenario.Set("node", std::string("/it"));
  scenario.Tick();
  scenario.Answer(false);
  ASSERT_EQ(scenario.LastCall().rfind("Ask ", 0), 0u);
  scenario.Set("health", Errors(""));
  EXPECT_EQ(scenario.Tick(), Status::kSuccess);
  EXPECT_EQ(scenario.LastCall(), "Withdraw node");
}

class RecoverLocalization : public testing::Test {
 protected:
  RecoverLocalization() {
    scenario_.Set("health", Errors("localization"));
    scenario_.Set("node", std::string("/localization"));
  }
  TreeScenario scenario_{"recovery/recover_localization.xml"};
};

TEST_F(RecoverLocalization, LooksAroundFirst) {
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "Rotate 6.2832 0.4");
}

TEST_F(RecoverLocalization, RestartsTheLocalizationAndLooksAroundAgain) {
  scenario_.Tick();
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /localization");
  scenario_.Answer(true);
  scenario_.Advance(10);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("Rotate 6.2832 0.4"), 2);
}

TEST_F(RecoverLocalization, AsksAPersonAtLast) {
  scenario_.Tick();
  scenario_.Answer(true);
  scenario_.Answer(true);
  scenario_.Advance(10);
  scenario_.Tick();
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.LastCall().rfind("Ask ", 0), 0u);
}

}  // namespace
}  // namespace coppice
