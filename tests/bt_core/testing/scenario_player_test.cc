#include "bt_core/testing/scenario_player.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"
#include "tests/bt_core/testing/with_stand_ins.h"

namespace coppice {
namespace {

constexpr char kTree[] = R"(
<root BTCPP_format="4" main_tree_to_execute="Main">
 <BehaviorTree ID="Main">
  <Sequence>
   <Go to="{goal}"/>
   <SubTree ID="In" name="in"/>
   <Sleep msec="{pause}"/>
  </Sequence>
 </BehaviorTree>
 <BehaviorTree ID="In"><Script code="n := 4"/></BehaviorTree>
</root>)";

std::shared_ptr<const Program> Compiled() {
  Diagnostics diagnostics;
  auto program = CompileWithStandIns(kTree, diagnostics);
  EXPECT_TRUE(program) << diagnostics.ToString();
  return program;
}

TEST(ScenarioPlayer, DoesWhatAStepSaysAndTellsWhatHappened) {
  const auto program = Compiled();
  ScenarioPlayer player(*program, {{{}, {"<Go>", {}}}});
  ScenarioStep step;
  step.set = {{{}, "pause", "200", KeyValue::Kind::kNumber}, {{}, "goal", "2;3"}};
  StepOutcome outcome = player.Play(step);
  EXPECT_EQ(outcome.status, Status::kRunning);
  ASSERT_EQ(outcome.events.size(), 1U);
  EXPECT_EQ(outcome.events[0].inputs,
            (std::vector<std::pair<std::string, std::string>>{{"to", "2;3"}}));
  EXPECT_TRUE(outcome.problems.empty());

  step = {};
  step.advance = std::chrono::milliseconds(200);
  EXPECT_EQ(player.Play(step).status, Status::kSuccess);
  EXPECT_EQ(player.clock().Now(), Time(std::chrono::milliseconds(1200)));
}

TEST(ScenarioPlayer, SaysWhatCannotBeDone) {
  const auto program = Compiled();
  ScenarioPlayer player(*program, {{{}, {"<Go>", {}}}});
  ScenarioStep step;
  step.set = {{{}, "paus", "2"}, {{}, "pause", "long"}};
  step.leaves = {{{}, {"Sleep", {}}}};
  std::string problems;
  for (const Difference& problem : player.Play(step).problems) {
    problems += problem.what + ": " + problem.expected + ", got " + problem.got + "\n";
  }
  EXPECT_EQ(problems,
            "key \"paus\": a key of the tree, got none, did you mean \"pause\"?\n"
            "key \"pause\": a value of type unsigned, got long\n"
            "leaves: a node with a script from the start that fits \"Sleep\", got none\n");
}

TEST(ScenarioPlayer, KeysOfInstancesGoByTheirPath) {
  const auto program = Compiled();
  std::string hint;
  const SlotIndex slot = FindKey(*program, "in/n", hint);
  ASSERT_NE(slot, kNoSlot);
  EXPECT_EQ(KeyPathOf(*program, slot), "in/n");
  EXPECT_EQ(FindKey(*program, "n", hint), kNoSlot);
}

}  // namespace
}  // namespace coppice
