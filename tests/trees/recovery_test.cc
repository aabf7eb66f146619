// The ladders of the recovery trees, each run alone.
#include <gtest/gtest.h>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

using leaves::Health;
using leaves::Pose2D;

Health Errors(const std::string& monitor) {
  Health health;
  if (!monitor.empty()) {
    health.entries.push_back({monitor, "it", "/it", leaves::HealthLevel::kError, "broken"});
  }
  return health;
}

class RecoverNavigation : public testing::Test {
 protected:
  RecoverNavigation() { scenario_.Set("health", Errors("navigation")); }
  // Neither waiting nor moving backwards nor more patience helps.
  void Fail() {
    scenario_.Tick();
    scenario_.Advance(20);
    scenario_.Tick();
    scenario_.Answer(false);
    scenario_.Advance(60);
    scenario_.Tick();
    scenario_.Answer(false);
  }
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

TEST_F(RecoverNavigation, WaitsLongerAndThenAsksAPersonWhenNeitherHelpsAndDoesNotWaitForIt) {
  scenario_.Tick();
  scenario_.Advance(20);
  scenario_.Tick();
  scenario_.Answer(true);
  scenario_.Advance(20);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_TRUE(scenario_.Runs("wait_longer"));
  EXPECT_EQ(scenario_.CallsBeginning("Ask"), 0) << "the way may be free before anybody comes";
  scenario_.Advance(60);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.CallsOf("Move -0.3 0.1"), 2);
  EXPECT_EQ(scenario_.Answer(false), Status::kFailure);
  EXPECT_EQ(scenario_.LastCall().rfind("Ask navigation: ", 0), 0u);
}

TEST_F(RecoverNavigation, AsksAPersonWhenItCannotMoveBackwards) {
  Fail();
  EXPECT_EQ(scenario_.LastCall().rfind("Ask navigation: ", 0), 0u);
}

TEST_F(RecoverNavigation, NeitherWaitsNorMovesAgainWhileAPersonIsAsked) {
  Fail();
  for (int i = 0; i < 500; ++i) {
    scenario_.Advance(1);
    EXPECT_EQ(scenario_.Tick(), Status::kFailure);
  }
  EXPECT_EQ(scenario_.CallsBeginning("Move"), 2);
  EXPECT_EQ(scenario_.CallsBeginning("Ask"), 1);
}

TEST_F(RecoverNavigation, AsksAgainTenMinutesAfterNobodyCouldHelp) {
  Fail();
  scenario_.robot.AnswerRequest("navigation", false);
  for (int i = 0; i < 599; ++i) {
    scenario_.Tick();
    scenario_.Advance(1);
  }
  EXPECT_EQ(scenario_.CallsBeginning("Ask"), 1);
  scenario_.Advance(2);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsBeginning("Ask"), 2);
}

TEST_F(RecoverNavigation, BeginsAnewWhenAPersonSaysThatItIsFixed) {
  Fail();
  scenario_.robot.AnswerRequest("navigation", true);
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_TRUE(scenario_.Runs("wait_and_retry"));
}

// A fault that flickers must not keep the ladder on its first rung for ever.
TEST_F(RecoverNavigation, GoesOnWithTheNextRungWhenTheFaultComesBackSoon) {
  scenario_.Tick();
  scenario_.Set("health", Errors(""));
  scenario_.Advance(20);
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  scenario_.Set("health", Errors("navigation"));
  scenario_.Advance(30);
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "Move -0.3 0.1");
}

TEST_F(RecoverNavigation, BeginsAtTheFirstRungAfterAMinuteOrAMetre) {
  scenario_.Set("pose", Pose2D{0, 0, 0});
  scenario_.Tick();
  scenario_.Set("health", Errors(""));
  scenario_.Advance(20);
  scenario_.Tick();
  scenario_.Set("health", Errors("navigation"));
  scenario_.Set("pose", Pose2D{1.1, 0, 0});
  scenario_.Advance(10);
  scenario_.Tick();
  EXPECT_TRUE(scenario_.Runs("wait_and_retry"));
  scenario_.Set("health", Errors(""));
  scenario_.Advance(20);
  scenario_.Tick();
  scenario_.Set("health", Errors("navigation"));
  scenario_.Advance(61);
  scenario_.Tick();
  EXPECT_TRUE(scenario_.Runs("wait_and_retry"));
}

TEST_F(RecoverNavigation, TakesUpTheSameRungAfterAnInterruption) {
  scenario_.Tick();
  scenario_.Advance(20);
  scenario_.Tick();
  ASSERT_EQ(scenario_.LastCall(), "Move -0.3 0.1");
  scenario_.Halt();
  scenario_.Tick();
  EXPECT_EQ(scenario_.LastCall(), "Move -0.3 0.1");
  EXPECT_EQ(scenario_.CallsBeginning("Move"), 2);
}

TEST_F(RecoverNavigation, RecordsEveryRecoveryWithItsPlace) {
  scenario_.Set("pose", Pose2D{1, 2, 3});
  Fail();
  ASSERT_EQ(scenario_.robot.events.size(), 6u);
  const leaves::RecoveryEvent& last = scenario_.robot.events[3];
  EXPECT_EQ(last.recovery, "move backwards");
  EXPECT_EQ(last.subject, "navigation");
  EXPECT_EQ(last.phase, leaves::RecoveryPhase::kFailed);
  ASSERT_TRUE(last.pose);
  EXPECT_EQ(last.pose->y, 2);
}

// Ten times in ten minutes it helped to wait: that is no help.
TEST_F(RecoverNavigation, DoesNotWaitOftenerThanItsBudgetAllows) {
  int waits = 0;
  for (int i = 0; i < 25; ++i) {
    scenario_.Set("health", Errors("navigation"));
    scenario_.Set("pose", Pose2D{2.0 * i, 0, 0});  // another place, so another episode
    scenario_.Tick();
    if (!scenario_.Runs("wait_and_retry")) break;
    ++waits;
    scenario_.Set("health", Errors(""));
    scenario_.Advance(20);
    scenario_.Tick();
  }
  EXPECT_EQ(waits, 10);
  EXPECT_EQ(scenario_.LastCall(), "Move -0.3 0.1");
}

class RecoverLocalization : public testing::Test {
 protected:
  RecoverLocalization() {
    scenario_.Set("health", Errors("localization"));
    scenario_.Set("node", std::string("/localization"));
  }
  // The turn under way ends.
  void Turn() {
    scenario_.Answer(true);
    scenario_.Advance(3);
    scenario_.Tick();
  }
  TreeScenario scenario_{"recovery/recover_localization.xml"};
};

TEST_F(RecoverLocalization, LooksAroundFirst) {
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "Rotate 6.2832 0.4");
}

TEST_F(RecoverLocalization, StopsTurningWhenThePositionIsKnown) {
  scenario_.Tick();
  scenario_.Set("health", Errors(""));
  EXPECT_EQ(scenario_.Tick(), Status::kSuccess);
  EXPECT_EQ(scenario_.LastCall(), "CancelMotion");
}

TEST_F(RecoverLocalization, RestartsTheLocalizationAndLooksAroundAgain) {
  scenario_.Tick();
  Turn();
  EXPECT_EQ(scenario_.LastCall(), "RestartNode /localization, cleared");
  scenario_.Answer(true);
  scenario_.Advance(10);
  scenario_.Tick();
  EXPECT_EQ(scenario_.CallsOf("Rotate 6.2832 0.4"), 2);
}

// Minutes without the program that turns the robot, which nobody restarts any more.
TEST_F(RecoverLocalization, UsesUpNoRungWhileTheNavigationIsDown) {
  scenario_.Tick();
  EXPECT_EQ(scenario_.Answer(false), Status::kRunning);  // the server has just died
  scenario_.Advance(3);
  Health health = Errors("localization");
  health.entries.push_back(
      {"node", "/navigation", "/navigation", leaves::HealthLevel::kError, "dead"});
  scenario_.Set("health", health);
  scenario_.robot.calls.clear();
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(scenario_.Tick(), Status::kFailure);
    scenario_.Advance(1);
  }
  EXPECT_EQ(scenario_.robot.calls, std::vector<std::string>{});
  scenario_.Set("health", Errors("localization"));
  EXPECT_EQ(scenario_.Tick(), Status::kRunning);
  EXPECT_EQ(scenario_.LastCall(), "Rotate 6.2832 0.4");
}

TEST_F(RecoverLocalization, AsksAPersonAtLastAndDoesNotWait) {
  scenario_.Tick();
  Turn();
  scenario_.Answer(true);
  scenario_.Advance(10);
  scenario_.Tick();
  Turn();
  EXPECT_EQ(scenario_.LastCall().rfind("Ask localization: ", 0), 0u);
  EXPECT_EQ(scenario_.Tick(), Status::kFailure);
  EXPECT_EQ(scenario_.CallsBeginning("Rotate"), 2);
}

class DockWithPatience : public testing::Test {
 protected:
  TreeScenario scenario_{"recovery/dock.xml"};
};

TEST_F(DockWithPatience, TriesFromFiveSidesThenLooksAround) {
  scenario_.Tick();
  for (int i = 0; i < 5; ++i) scenario_.Answer(false);
  EXPECT_EQ(scenario_.robot.calls,
            (std::vector<std::string>{"Dock 0 1", "Dock 0.04 1", "Dock -0.04 1", "Dock 0.08 1",
                                      "Dock -0.08 1", "Rotate 6.2832 0.4"}));
  scenario_.Answer(true);
  scenario_.Answer(true);
  EXPECT_EQ(scenario_.LastCall(), "Dock 0 3");
  EXPECT_EQ(scenario_.Answer(true), Status::kSuccess);
}

TEST_F(DockWithPatience, FailsWhenNothingHelps) {
  scenario_.Tick();
  for (int i = 0; i < 5; ++i) scenario_.Answer(false);
  EXPECT_EQ(scenario_.Answer(false), Status::kFailure);
}

}  // namespace
}  // namespace coppice
