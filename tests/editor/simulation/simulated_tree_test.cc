#include "editor/simulation/simulated_tree.h"

#include <gtest/gtest.h>

#include "editor/timeline/run.h"
#include "tests/editor/simulation/simulated_text.h"

namespace coppice::editor {
namespace {

constexpr Duration kTick = std::chrono::milliseconds(100);

ScenarioStep After(Duration time) {
  ScenarioStep step;
  step.advance = time;
  return step;
}

TEST(SimulatedTree, TheSameSeedIsTheSameHistory) {
  const auto program = CompiledRoot("<Sequence><IsDay/><Go/></Sequence>");
  const auto statuses = [&](std::optional<std::uint64_t> seed) {
    std::optional<Chance> chance;
    if (seed) chance = Chance{*seed, {}};
    SimulatedTree tree(program, chance, nullptr);
    std::string text;
    for (int i = 0; i < 200; ++i) text += ToString(tree.Play(After(kTick)).status)[0];
    return text;
  };
  EXPECT_EQ(statuses(7), statuses(7));
  EXPECT_NE(statuses(7), statuses(8));
  EXPECT_NE(statuses(7).find('F'), std::string::npos);
  EXPECT_EQ(statuses(std::nullopt).find('F'), std::string::npos) << "no chance without a seed";
}

TEST(SimulatedTree, KeysAndLeavesFollowWhatTheFileSaysOfChance) {
  const auto program = CompiledRoot(R"(<Fallback><Go to="{goal}"/><Call/></Fallback>)");
  Chance chance{3, {}};
  MockScript fails;
  fails.results = {Status::kFailure};
  chance.play.leaves = {{{}, {"<G*>", fails}}};
  chance.play.set = {{{{}, "goal", "lab", KeyValue::Kind::kString}}};
  SimulatedTree tree(program, chance, nullptr);
  EXPECT_EQ(tree.player().tree().executor().ticks(), 0U);
  tree.Play(After(Duration(0)));
  EXPECT_EQ(tree.state().last(NodeIndex{1}), Status::kFailure);
  EXPECT_EQ(tree.player().tree().executor().blackboard()[SlotIndex{0}].value.Print(), "lab");
}

TEST(SimulatedTree, TellsItsHistoryAsARobotDoes) {
  editor::Run run;
  SimulatedTree tree(CompiledRoot("<Sequence><IsDay/><Go/></Sequence>"), std::nullopt, &run);
  EXPECT_TRUE(run.has_tree());
  tree.Play(After(Duration(0)));
  tree.Play(After(std::chrono::seconds(1)));
  ASSERT_EQ(run.size(), 2U);
  EXPECT_EQ(run.TracksAt(0).LaneOf(NodeIndex{2}).At(0), Status::kRunning);
  EXPECT_EQ(run.TracksAt(1).LaneOf(NodeIndex{2}).At(1), Status::kSuccess);
  EXPECT_EQ(run.TimeOf(1) - run.TimeOf(0), std::chrono::seconds(1));
  EXPECT_EQ(run.now().last(NodeIndex{2}), Status::kSuccess);
}

TEST(SimulatedTree, AReloadIsAnotherTreeOfTheSameRun) {
  editor::Run run;
  SimulatedTree tree(CompiledRoot("<Sequence><Go/></Sequence>"), std::nullopt, &run);
  tree.Play(After(Duration(0)));
  tree.Reload(CompiledRoot("<Fallback><New/><Go/></Fallback>"));
  tree.Play(After(Duration(0)));
  EXPECT_EQ(run.TracksAt(run.size() - 1).tree()->nodes.size(), 3U);
  EXPECT_EQ(run.now().status(NodeIndex{1}), Status::kRunning);
  EXPECT_FALSE(run.breaks().back().is_other_run);
}

TEST(SimulatedTree, WhoIsToldLaterLearnsHowItStands) {
  SimulatedTree tree(CompiledRoot("<Sequence><IsDay/><Go/></Sequence>"), std::nullopt, nullptr);
  tree.Play(After(Duration(0)));
  editor::Run run;
  tree.TellTo(run, false);
  EXPECT_EQ(run.now().status(NodeIndex{2}), Status::kRunning);
  EXPECT_EQ(run.now().last(NodeIndex{1}), Status::kSuccess);
}

}  // namespace
}  // namespace coppice::editor
