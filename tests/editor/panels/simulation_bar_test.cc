#include <gtest/gtest.h>

#include "editor/simulation/script_text.h"
#include "editor/workspace/simulation_editor.h"
#include "tests/editor/driver.h"
#include "tests/editor/sample_trees.h"

namespace coppice::editor {
namespace {

class SimulationBarTest : public testing::Test {
 protected:
  SimulationBarTest() : file_("patrol.xml", kPatrolTree) {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  EditorState& state() { return driver_.editor.state(); }
  Simulation& simulation() { return *state().simulator.get(); }
  void Start() {
    driver_.Press(kKeyF1 + 4);
    driver_.Frames();
  }
  void Answer(const std::string& text) {
    driver_.Type(text);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }
  // By the name of the node.
  bool ClickNode(const std::string& name) {
    const Scene& scene = *driver_.view().scene();
    for (const SceneNode& node : scene.nodes) {
      if (node.name != name) continue;
      return driver_.Click("canvas/" + scene.tree_id + "/" + node.path);
    }
    return false;
  }
  Status StatusOf(const std::string& name) {
    const RunView& run = *state().workspace.run();
    const auto& nodes = run.tree()->description()->nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].path == name) return run.state().states[i].status;
    }
    return Status::kIdle;
  }

  TemporaryFile file_;
  Driver driver_;
};

TEST_F(SimulationBarTest, CanBeEndedInTheNarrowestWindow) {
  driver_.input.width = 900;
  driver_.input.height = 600;
  Start();
  ASSERT_TRUE(driver_.Click("sim/end"));
  driver_.Frames();
  EXPECT_EQ(state().simulator.get(), nullptr);
}

TEST_F(SimulationBarTest, LeavesRoomForTheTreeInALowWindow) {
  driver_.input.width = 900;
  driver_.input.height = 600;
  driver_.OpenRow();
  Start();
  driver_.Click("sim/tick");
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("xml"));
  EXPECT_GE(driver_.BoxOf("canvas").height(), 195);
  EXPECT_TRUE(driver_.Has("run/coverage")) << "the last of the tabs";
}

TEST_F(SimulationBarTest, NoTooltipLiesOverTheAnswersOfALeaf) {
  Start();
  ASSERT_TRUE(ClickNode("to door"));
  driver_.MoveTo(driver_.BoxOf("outline").center());
  driver_.Frames(4);
  const Box answers = driver_.BoxOf("sim/success");
  const Color panel = GetPalette(PaletteName::kDark).panel;
  const Box around = {answers.min - Point{20, 40}, answers.max + Point{200, 60}};
  const int before = driver_.CountColor(around, panel, 2);
  ASSERT_TRUE(ClickNode("to door"));
  driver_.Frames(4);
  EXPECT_NEAR(driver_.CountColor(around, panel, 2), before, 50);
}

TEST_F(SimulationBarTest, NobodyTakesASimulationForARobot) {
  EXPECT_FALSE(driver_.Has("sim/banner"));
  Start();
  EXPECT_TRUE(driver_.Has("sim/banner"));
  EXPECT_EQ(state().workspace.run()->phase(), RunPhase::kSimulation);
  driver_.Press(kKeyF1 + 4, kShift);
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("sim/banner"));
  EXPECT_EQ(state().workspace.run(), nullptr);
  EXPECT_EQ(state().workspace.ShownTreeId(), "Patrol");
}

TEST_F(SimulationBarTest, TicksRunsAndGoesBack) {
  Start();
  EXPECT_TRUE(driver_.Click("sim/tick"));
  driver_.Frames();
  EXPECT_EQ(StatusOf("to door"), Status::kRunning);
  driver_.Press(kKeySpace);
  driver_.Frames(30);  // 0.6 s
  EXPECT_GE(simulation().ticks(), 5U);
  EXPECT_EQ(driver_.editor.state().simulator.is_playing(), true);
  driver_.Click("sim/play");
  const std::uint64_t ticks = simulation().ticks();
  driver_.Press(kKeyBackspace);
  driver_.Frames();
  EXPECT_EQ(simulation().ticks(), ticks - 1);
  driver_.Press(kKeyF1 + 9, kShift);
  driver_.Frames();
  EXPECT_EQ(StatusOf("say"), Status::kRunning);
}

TEST_F(SimulationBarTest, FromThePastItGoesOnThere) {
  Start();
  for (int i = 0; i < 12; ++i) driver_.Press(kKeyF1 + 9);
  driver_.Frames();
  EXPECT_EQ(StatusOf("say"), Status::kRunning);
  state().workspace.run()->playhead().GoToTick(2);
  driver_.Frames();
  EXPECT_EQ(StatusOf("to door"), Status::kRunning);
  driver_.Press(kKeyF1 + 9);
  driver_.Frames();
  EXPECT_EQ(simulation().ticks(), 4U);
  EXPECT_TRUE(state().workspace.run()->playhead().is_at_now());
  EXPECT_EQ(StatusOf("to door"), Status::kRunning);
}

TEST_F(SimulationBarTest, TheUserAnswersForALeaf) {
  Start();
  driver_.Press(kKeyF1 + 9);
  ASSERT_TRUE(ClickNode("to door"));
  driver_.Frames();
  EXPECT_TRUE(driver_.Click("sim/success"));
  driver_.Frames();
  EXPECT_EQ(StatusOf("say"), Status::kRunning);
  EXPECT_EQ(simulation().ticks(), 2U);
  driver_.Press(kKeyEnter);
  driver_.Frames();
  state().popup.text.clear();
  Answer("300ms FAILURE");
  EXPECT_EQ(state().popup.kind, Popup::kNone);
  const NodeIndex leaf = SimulationEditor(state(), 0).SelectedLeaf();
  ASSERT_NE(leaf, kNoNode) << "it is still selected";
  EXPECT_EQ(PrintScript(*simulation().ScriptOf(leaf)), "300ms FAILURE");
}

TEST_F(SimulationBarTest, AnEditIsReloadedAndErrorsAreSaid) {
  Start();
  driver_.Press(kKeyF1 + 9);
  std::string text = kPatrolTree;
  text.replace(text.find(R"(<Dock name="dock"/>)"), 19, "<Inverter/>");
  state().workspace.project().SetText(file_.path(), "Type", text);
  driver_.Frames(20);
  EXPECT_FALSE(state().simulator.problem().empty());
  EXPECT_EQ(StatusOf("to door"), Status::kRunning);
  text.replace(text.find("<Inverter/>"), 11, R"(<Park name="park"/>)");
  state().workspace.project().SetText(file_.path(), "Type", text);
  driver_.Frames(20);
  EXPECT_TRUE(state().simulator.problem().empty());
  EXPECT_EQ(StatusOf("to door"), Status::kRunning) << "it lives on";
  EXPECT_EQ(simulation().program()->Id(NodeIndex{4}), "Park");
}

// The story: simulate the patrol until the battery is low, see the recharge branch, save it as a
// test, run the test.
TEST_F(SimulationBarTest, AStoryFromTheSimulationToTheTest) {
  Start();
  driver_.Press('B', kCtrl);
  driver_.Frames();
  Answer("battery = 0.8");
  driver_.Press(kKeyF1 + 9);
  driver_.Press(kKeyF1 + 9, kShift);
  driver_.Frames();
  EXPECT_EQ(StatusOf("say"), Status::kRunning) << "on patrol";
  driver_.Picture("simulation_patrol");

  driver_.Press('B', kCtrl);
  driver_.Frames();
  Answer("battery = 0.2");
  driver_.Press(kKeyF1 + 9);
  driver_.Frames();
  EXPECT_EQ(StatusOf("to station"), Status::kRunning) << "the recharge branch";
  EXPECT_EQ(StatusOf("say"), Status::kIdle);
  ASSERT_TRUE(ClickNode("to station"));
  driver_.Frames(30);
  driver_.Picture("simulation_recharge");
  driver_.Press('1');
  driver_.Frames();
  EXPECT_EQ(StatusOf("dock"), Status::kRunning);
  driver_.Press(kKeyF1 + 9, kShift);
  driver_.Frames();
  EXPECT_EQ(state().simulator.result(), Status::kSuccess);

  EXPECT_TRUE(driver_.Click("sim/save_test"));
  driver_.Frames();
  Answer("recharges when the battery is low");
  ASSERT_EQ(state().popup.kind, Popup::kNone) << state().popup.error;
  ASSERT_EQ(state().tests.all().size(), 1U);
  driver_.Press('R', kCtrl | kShift);
  driver_.Frames(30);
  EXPECT_EQ(state().tests.all()[0].state, ScenarioTest::State::kPassed);
  EXPECT_TRUE(driver_.Has("tests/0"));
  driver_.Picture("simulation_test_passed");

  // With another threshold the tree does something else, and the test says where.
  std::string text = kPatrolTree;
  text.replace(text.find("0.3"), 3, "0.1");
  state().workspace.project().SetText(file_.path(), "Type", text);
  driver_.Press('R', kCtrl | kShift);
  driver_.Frames(30);
  EXPECT_EQ(state().tests.all()[0].state, ScenarioTest::State::kFailed);
  EXPECT_TRUE(driver_.Has("tests/0/0"));
  driver_.Picture("simulation_test_failed");
}

}  // namespace
}  // namespace coppice::editor
