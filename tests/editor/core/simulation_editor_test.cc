#include "editor/core/simulation_editor.h"

#include <gmock/gmock.h>

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
  EXPECT_EQ(Simulate().SetKey("goal = 1"), "there is no simulation");
  EXPECT_EQ(Simulate().RunOften("10"), "there is no simulation");
  EXPECT_EQ(Simulate().RunTicks("10"), "there is no simulation");
  EXPECT_EQ(Simulate().SaveAsScenario("a"), "a name is needed");
  EXPECT_EQ(Simulate().SetScript("SUCCESS"), "select a leaf first");
  Simulate().Tick();
  Simulate().GoToFinding({});
}

TEST_F(SimulationEditorTest, NumbersAreNumbers) {
  Start();
  for (const char* text : {"", "0", "-1", "x", "1 2", "99999999999999999999"}) {
    EXPECT_THAT(Simulate().RunOften(text), HasSubstr("a number from 1")) << text;
    EXPECT_THAT(Simulate().RunTicks(text), HasSubstr("a number from 1")) << text;
  }
  EXPECT_EQ(Simulate().SetSeed("x"), "a seed is a whole number");
  EXPECT_EQ(Simulate().SetSeed("12"), "");
  EXPECT_EQ(simulation().seed(), 12U);
  EXPECT_EQ(Simulate().SetSeed(""), "");
  EXPECT_EQ(simulation().seed(), std::nullopt);
}

TEST_F(SimulationEditorTest, SoManyTicksOrUntilTheTreeIsDone) {
  Start();
  EXPECT_EQ(Simulate().RunTicks("3"), "");
  EXPECT_EQ(simulation().ticks(), 3U);
  EXPECT_EQ(Simulate().RunTicks("100"), "");
  EXPECT_EQ(simulation().ticks(), 11U) << "a second";
  EXPECT_EQ(state().simulator.result(), Status::kSuccess);
}

TEST_F(SimulationEditorTest, KeysAreSetByAssignment) {
  Start();
  EXPECT_EQ(Simulate().SetKey("goal = kitchen"), "");
  EXPECT_THAT(Simulate().SetKey("goal"), HasSubstr("battery_level = 0.2"));
  EXPECT_THAT(Simulate().SetKey("gaol = 1"), HasSubstr("no key \"gaol\""));
  Simulate().Tick();
  EXPECT_EQ(simulation().ValueOf("goal"), "kitchen");
}

TEST_F(SimulationEditorTest, ManyRunsKnowWhatTheSimulationWasTold) {
  Start();
  driver_.view().Select(driver_.view().scene()->FindPath("1.2"));
  EXPECT_EQ(Simulate().SetScript("FAILURE"), "");
  Simulate().Tick();
  EXPECT_EQ(Simulate().RunOften("50"), "");
  while (state().coverage.is_running()) state().coverage.Update();
  const NodeCoverage& go = *state().coverage.Find("go");
  EXPECT_GT(go.results_of(Status::kFailure), 0U);
  EXPECT_EQ(go.results_of(Status::kSuccess), 0U) << "its script is what the user has said";
  EXPECT_EQ(state().run_tab, RunTab::kCoverage);
}

TEST_F(SimulationEditorTest, AnotherSimulationForgetsWhatTheLastOneReached) {
  Start();
  EXPECT_EQ(Simulate().RunOften("5"), "");
  ASSERT_NE(state().coverage.coverage(), nullptr);
  Simulate().End();
  driver_.Frames();
  Start();
  EXPECT_EQ(state().coverage.coverage(), nullptr);
}

}  // namespace
}  // namespace coppice::editor
