#include "editor/workspace/simulation_editor.h"

#include <gmock/gmock.h>

#include <fstream>

#include "editor/live/run_summary.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

constexpr char kFile[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main"><Sequence><IsDay/><Go name="go" to="{goal}"/></Sequence></BehaviorTree>
</root>
)";

class SimulationEditorTest : public testing::Test {
 protected:
  SimulationEditorTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  EditorState& state() { return driver_.editor.state(); }
  SimulationEditor Simulate() { return {state(), 0}; }
  Simulation& simulation() { return *state().simulator.get(); }
  void Start() {
    Simulate().Start();
    driver_.Frames();
  }

  TemporaryFile file_{"main.xml", kFile};
  Driver driver_;
};

TEST_F(SimulationEditorTest, WithoutASimulationItSaysWhatIsMissing) {
  EXPECT_FALSE(Simulate().IsShown());
  EXPECT_EQ(Simulate().SetKey("goal = 1").problem(), "there is no simulation");
  EXPECT_EQ(Simulate().RunOften("10").problem(), "there is no simulation");
  EXPECT_EQ(Simulate().RunTicks("10").problem(), "there is no simulation");
  EXPECT_EQ(Simulate().SaveAsScenario("a").problem(), "a name is needed");
  EXPECT_EQ(Simulate().SetScript("SUCCESS").problem(), "select a leaf first");
  Simulate().Tick();
  Simulate().GoToFinding({});
}

TEST_F(SimulationEditorTest, NumbersAreNumbers) {
  Start();
  for (const char* text : {"", "0", "-1", "x", "1 2", "99999999999999999999"}) {
    EXPECT_THAT(Simulate().RunOften(text).problem(), HasSubstr("a number from 1")) << text;
    EXPECT_THAT(Simulate().RunTicks(text).problem(), HasSubstr("a number from 1")) << text;
  }
  EXPECT_EQ(Simulate().SetSeed("x").problem(), "a seed is a whole number");
  EXPECT_EQ(Simulate().SetSeed("12").problem(), "");
  EXPECT_EQ(simulation().chance()->seed, 12U);
  EXPECT_EQ(Simulate().SetSeed("").problem(), "");
  EXPECT_FALSE(simulation().chance());
}

TEST_F(SimulationEditorTest, SoManyTicksOrUntilTheTreeIsDone) {
  Start();
  EXPECT_EQ(Simulate().RunTicks("3").problem(), "");
  EXPECT_EQ(simulation().ticks(), 3U);
  EXPECT_EQ(Simulate().RunTicks("100").problem(), "");
  EXPECT_EQ(simulation().ticks(), 11U) << "a second";
  EXPECT_EQ(state().simulator.result(), Status::kSuccess);
}

TEST_F(SimulationEditorTest, KeysAreSetByAssignment) {
  Start();
  EXPECT_EQ(Simulate().SetKey("goal = kitchen").problem(), "");
  EXPECT_THAT(Simulate().SetKey("goal").problem(), HasSubstr("battery_level = 0.2"));
  EXPECT_THAT(Simulate().SetKey("gaol = 1").problem(), HasSubstr(R"(no key "gaol")"));
  Simulate().Tick();
  EXPECT_EQ(simulation().ValueOf("goal"), "kitchen");
}

// After "again" the run has each number twice.
TEST_F(SimulationEditorTest, AllThatIsShownGoesBackWithTheSimulation) {
  Start();
  EXPECT_EQ(Simulate().RunTicks("3").problem(), "");
  Simulate().PlayAgain();
  driver_.Frames();
  Simulate().Back();
  driver_.Frames();
  const RunView& run = *state().workspace.run();
  EXPECT_FALSE(run.playhead().is_at_now());
  EXPECT_EQ(run.playhead().tick(), 4U) << "the timeline: the second of three ticks, again";
  EXPECT_EQ(SummaryOf(run), "tick 2") << "the strip";
  EXPECT_EQ(simulation().ticks(), 2U);
  EXPECT_EQ(Simulate().SetKey("goal = kitchen").problem(), "");
  EXPECT_EQ(run.playhead().tick(), 4U) << "nothing was ticked";
  Simulate().Tick();
  driver_.Frames();
  EXPECT_EQ(simulation().ValueOf("goal"), "kitchen");
  EXPECT_EQ(run.playhead().tick(), 6U);
  EXPECT_EQ(SummaryOf(run), "tick 3");
}

TEST_F(SimulationEditorTest, ABeginningIsNoTickOfTheRunBefore) {
  Start();
  EXPECT_EQ(Simulate().RunTicks("100").problem(), "");
  const RunView& run = *state().workspace.run();
  Simulate().Restart();
  driver_.Frames();
  EXPECT_TRUE(run.is_at_beginning());
  EXPECT_EQ(SummaryOf(run), "tick 0");
  EXPECT_FALSE(state().simulator.result());
  Simulate().Tick();
  driver_.Frames();
  EXPECT_EQ(SummaryOf(run), "tick 1");
  Simulate().Back();
  driver_.Frames();
  EXPECT_TRUE(run.is_at_beginning());
}

TEST_F(SimulationEditorTest, ManyRunsKnowWhatTheSimulationWasTold) {
  Start();
  driver_.view().Select(driver_.view().scene()->FindPath("1.2"));
  EXPECT_EQ(Simulate().SetScript("FAILURE").problem(), "");
  Simulate().Tick();
  EXPECT_EQ(Simulate().RunOften("50").problem(), "");
  while (state().coverage.is_running()) state().coverage.Update();
  const NodeCoverage& go = *state().coverage.Find("go");
  EXPECT_GT(go.results_of(Status::kFailure), 0U);
  EXPECT_EQ(go.results_of(Status::kSuccess), 0U) << "its script is what the user has said";
  EXPECT_EQ(state().run.tab, RunTab::kCoverage);
}

TEST_F(SimulationEditorTest, AnotherSimulationForgetsWhatTheLastOneReached) {
  Start();
  EXPECT_EQ(Simulate().RunOften("5").problem(), "");
  ASSERT_NE(state().coverage.coverage(), nullptr);
  Simulate().End();
  driver_.Frames();
  Start();
  EXPECT_EQ(state().coverage.coverage(), nullptr);
}

constexpr char kScenarios[] = R"({"tree": "main.xml",
  "random": {"set": {"goal": ["lab", "hall"]}, "leaves": {"<Go>": "FAILURE"}, "lasts_ms": 2000},
  "scenarios": [{"name": "a", "leaves": {"<*>": "SUCCESS"}, "steps": [{}]}]}
)";

class SimulationEditorByChance : public SimulationEditorTest {
 protected:
  SimulationEditorByChance() { WriteScenarios(kScenarios); }
  void WriteScenarios(const std::string& text) const {
    std::ofstream(file_.folder() + "/main.test.json") << text;
  }
  std::string Scenarios() const {
    std::ifstream stream(file_.folder() + "/main.test.json");
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(SimulationEditorByChance, ASeedPlaysAsTheScenariosBesideTheTreeSay) {
  Start();
  EXPECT_EQ(Simulate().SetSeed("7").problem(), "");
  EXPECT_EQ(Simulate().RunTicks("100").problem(), "");
  EXPECT_GE(simulation().now(), std::chrono::seconds(2)) << "it was begun anew";
  EXPECT_THAT(simulation().ValueOf("goal"), testing::AnyOf("lab", "hall"));
  EXPECT_EQ(state().simulator.result(), Status::kFailure);
  EXPECT_EQ(simulation().chance()->play.where.line, 2U);
}

TEST_F(SimulationEditorByChance, SoDoManyRuns) {
  Start();
  EXPECT_EQ(Simulate().RunOften("50").problem(), "");
  while (state().coverage.is_running()) state().coverage.Update();
  EXPECT_EQ(state().coverage.Find("go")->results_of(Status::kSuccess), 0U);
  EXPECT_EQ(state().coverage.coverage()->ticks, 50U * 20) << "two seconds each";
  driver_.view().Select(driver_.view().scene()->FindPath("1.2"));
  EXPECT_EQ(Simulate().SetScript("SUCCESS").problem(), "");
  EXPECT_EQ(Simulate().RunOften("50").problem(), "");
  while (state().coverage.is_running()) state().coverage.Update();
  EXPECT_EQ(state().coverage.Find("go")->results_of(Status::kFailure), 0U)
      << "what the user says is more important";
}

TEST_F(SimulationEditorByChance, AnErrorInTheScenariosIsSaidWithItsPlace) {
  std::string wrong = kScenarios;
  wrong.replace(wrong.find(R"("goal")"), 6, R"("gaol")");
  Start();
  WriteScenarios(wrong);
  const std::string said = R"(main.test.json:2:31: error: the tree has no key "gaol")";
  EXPECT_THAT(Simulate().SetSeed("7").problem(), HasSubstr(said));
  EXPECT_FALSE(simulation().chance());
  EXPECT_THAT(Simulate().RunOften("7").problem(), HasSubstr(said));
  EXPECT_EQ(state().coverage.coverage(), nullptr);
  WriteScenarios(R"({"tree": 1})");
  Simulate().End();
  driver_.Frames();
  Start();
  ASSERT_TRUE(Simulate().IsShown()) << "the tree itself is good";
  EXPECT_THAT(state().notice.text, HasSubstr("main.test.json:1:"));
}

TEST_F(SimulationEditorByChance, WhatIsSavedAsATestPassesAndTheRestOfTheFileStays) {
  Start();
  EXPECT_EQ(Simulate().SetSeed("7").problem(), "");
  EXPECT_EQ(Simulate().RunTicks("25").problem(), "");
  EXPECT_EQ(Simulate().SaveAsScenario("by chance").problem(), "");
  const std::string old = kScenarios;
  const std::size_t end_of_last = old.rfind(']');
  EXPECT_EQ(Scenarios().substr(0, end_of_last), old.substr(0, end_of_last));
  Simulate().RunScenarios();
  EXPECT_EQ(state().notice.text, "2 of 2 tests passed");
}

}  // namespace
}  // namespace coppice::editor
