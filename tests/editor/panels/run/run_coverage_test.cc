#include <gtest/gtest.h>

#include <fstream>

#include "editor/workspace/simulation_editor.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kPatrol[] = R"(<root BTCPP_format="4" main_tree_to_execute="Patrol">
  <BehaviorTree ID="Patrol">
    <Fallback name="patrol">
      <Sequence name="round">
        <ScriptCondition name="charged?" code="battery &gt; 0.3"/>
        <GoTo name="to door" place="door"/>
        <Say name="say" text="All quiet."/>
      </Sequence>
      <GoTo name="to station" place="station"/>
      <AlwaysSuccess name="give up"/>
      <Say name="call" text="Help!"/>
    </Fallback>
  </BehaviorTree>
</root>
)";

class RunCoverageTest : public testing::Test {
 protected:
  RunCoverageTest() : file_("patrol.xml", kPatrol) {
    driver_.editor.Open(file_.path());
    driver_.Frames();
    driver_.Press(kKeyF1 + 4);
    driver_.Frames();
  }
  EditorState& state() { return driver_.editor.state(); }
  Simulation& simulation() { return *state().simulator.get(); }
  void Answer(const std::string& text) {
    driver_.Press('A', kCtrl);
    driver_.Press(kKeyBackspace);
    driver_.Type(text);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }
  void RunOften(const std::string& runs) {
    driver_.Press('X', kShift);
    driver_.Frames();
    Answer(runs);
    while (state().coverage.is_running()) driver_.Frames(1);
    driver_.Frames();
  }

  TemporaryFile file_;
  Driver driver_;
};

TEST_F(RunCoverageTest, ListsWhatWasNeverReachedAndAClickShowsIt) {
  EXPECT_TRUE(simulation().SetKey("battery", "0.8"));
  RunOften("400");
  EXPECT_EQ(state().popup.kind, Popup::kNone) << state().popup.error;
  EXPECT_EQ(state().coverage.coverage()->runs, 400U);
  EXPECT_TRUE(driver_.Has("run/coverage/never_ticked/call"));
  EXPECT_TRUE(driver_.Has("run/coverage/never_failure/charged?"));
  EXPECT_FALSE(driver_.Has("run/coverage/never_failure/to door"));
  EXPECT_FALSE(driver_.Has("run/coverage/finding/0"));
  EXPECT_FALSE(driver_.Has("run/hooks")) << "a simulation has no breakpoints";
  EXPECT_TRUE(driver_.Click("run/coverage/never_ticked/call"));
  driver_.Frames();
  EXPECT_EQ(driver_.Selected(), "1.4");
  EXPECT_EQ(state().run.heat, HeatMode::kTicks) << "the canvas shows it";
  driver_.Frames(30);
  driver_.Picture("coverage_dark");
  state().screen.palette = PaletteName::kLight;
  driver_.Frames();
  driver_.Picture("coverage_light");
}

TEST_F(RunCoverageTest, AClickOnAFindingSimulatesTheRunThatHadIt) {
  RunOften("5");
  ASSERT_TRUE(driver_.Has("run/coverage/finding/0")) << "nobody has written the battery";
  driver_.Picture("coverage_finding");
  EXPECT_TRUE(driver_.Click("run/coverage/finding/0"));
  driver_.Frames();
  EXPECT_EQ(simulation().chance()->seed, 1U);
  EXPECT_EQ(simulation().ticks(), state().coverage.coverage()->findings[0].tick);
}

TEST_F(RunCoverageTest, TheSimulationIsTheSameAsTheRunOfItsSeed) {
  EXPECT_TRUE(simulation().SetKey("battery", "0.8"));
  RunOften("1");
  const Coverage coverage = *state().coverage.coverage();
  simulation().PlayRun({1, state().coverage.play()}, coverage.ticks, state().simulator.period());
  EXPECT_EQ(simulation().ticks(), coverage.ticks);
  const Status result = simulation().state().last(kRootNode);
  EXPECT_EQ(coverage.results[static_cast<std::size_t>(result)], 1U);
}

TEST_F(RunCoverageTest, LeavesByChanceAreShownAndSwitchedOff) {
  driver_.Press('X');
  driver_.Frames();
  Answer("no");
  EXPECT_FALSE(state().popup.error.empty());
  Answer("7");
  EXPECT_EQ(simulation().chance()->seed, 7U);
  state().commands.Run("sim.ticks");
  driver_.Frames();
  Answer("300");
  EXPECT_GT(simulation().ticks(), 0U);
  const std::uint64_t ticks = simulation().ticks();
  EXPECT_TRUE(state().simulator.result()) << "the patrol ends";
  EXPECT_TRUE(driver_.Click("sim/chance"));
  driver_.Frames();
  Answer("7");
  state().commands.Run("sim.ticks");
  driver_.Frames();
  Answer("300");
  EXPECT_EQ(simulation().ticks(), ticks) << "the same seed, the same run";
  driver_.Press('X');
  driver_.Frames();
  Answer("");
  EXPECT_FALSE(simulation().chance());
}

TEST_F(RunCoverageTest, SaysWhoseWordCountsAndAFindingIsFoundAgainWithIt) {
  RunOften("5");
  EXPECT_FALSE(driver_.Has("run/coverage/origin"));
  std::ofstream(file_.folder() + "/patrol.test.json")
      << R"({"tree": "patrol.xml", "random": {"set": {"battery": [0.8, 0.9]},
             "leaves": {"say": {"throws": "no voice"}}},
             "scenarios": [{"name": "a", "steps": [{}]}]})";
  RunOften("200");
  EXPECT_TRUE(driver_.Has("run/coverage/origin"));
  ASSERT_EQ(state().coverage.coverage()->findings.size(), 1U) << "somebody writes the battery";
  const RandomFinding finding = state().coverage.coverage()->findings[0];
  EXPECT_TRUE(driver_.Click("run/coverage/finding/0"));
  driver_.Frames();
  EXPECT_EQ(simulation().ticks(), finding.tick);
  EXPECT_EQ(simulation().state().last(NodeIndex{4}), Status::kFailure) << "say threw";
  EXPECT_TRUE(driver_.Has("sim/chance_origin"));
  driver_.view().ZoomAt({0, 0}, 2);
  driver_.view().camera.offset = {-3000, -3000};  // no node is in sight
  driver_.view().minimap.corner = Corner::kLowerLeft;
  driver_.Frames();
  ASSERT_TRUE(driver_.Has("canvas/minimap"));
  EXPECT_FALSE(driver_.BoxOf("canvas/minimap").Overlaps(driver_.BoxOf("sim/chance_origin")));
  driver_.Picture("coverage_origin");
}

TEST_F(RunCoverageTest, SaysThatTheTreeWasEditedSince) {
  RunOften("5");
  EXPECT_FALSE(driver_.Has("run/coverage/old"));
  std::string text = kPatrol;
  text.replace(text.find("give up"), 7, "rest");
  state().workspace.project().SetText(file_.path(), "Type", text);
  driver_.Frames(20);
  EXPECT_TRUE(driver_.Has("run/coverage/old"));
}

}  // namespace
}  // namespace coppice::editor
