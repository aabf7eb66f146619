#include "bt_core/testing/stand_in.h"

#include <gtest/gtest.h>

#include "bt_core/testing/scenario_player.h"
#include "tests/bt_core/testing/with_stand_ins.h"

namespace coppice {
namespace {

std::shared_ptr<const Program> Compiled(const std::string& inside) {
  Diagnostics diagnostics;
  auto program = CompileWithStandIns(
      R"(<root BTCPP_format="4" main_tree_to_execute="Main">)" + inside + "</root>", diagnostics);
  EXPECT_TRUE(program) << diagnostics.ToString();
  return program;
}

TEST(StandIn, HasThePortsThatTheTreeGivesIt) {
  const auto program =
      Compiled(R"(<BehaviorTree ID="Main"><Sequence><IsLow level="{battery}" limit="0.3"/>)"
               R"(<Action ID="Go" to="{goal}"/></Sequence></BehaviorTree>)");
  ASSERT_TRUE(program);
  std::string hint;
  EXPECT_NE(FindKey(*program, "battery", hint), kNoSlot);
  EXPECT_NE(FindKey(*program, "goal", hint), kNoSlot);
  EXPECT_TRUE(IsStandIn(*program->registry->Find("Go")));
  EXPECT_FALSE(IsStandIn(*program->registry->Find("Sleep")));
  ScenarioPlayer player(*program, {{{}, {"Go", {}}}});
  EXPECT_EQ(player.UnplayedNodes(), std::vector{NodeIndex{1}});
}

constexpr const char* kGuarded =
    R"(<BehaviorTree ID="Main"><Guarded limit="{limit}"><Inverter><AlwaysFailure/></Inverter>)"
    "</Guarded></BehaviorTree>";
constexpr const char* kGuardedModel =
    R"(<TreeNodesModel><Decorator ID="Guarded"><input_port name="limit" type="double"/>)"
    "</Decorator></TreeNodesModel>";

TEST(StandIn, ADecoratorWithModelReturnsWhatItsChildReturns) {
  const auto program = Compiled(std::string(kGuarded) + kGuardedModel);
  ASSERT_TRUE(program);
  std::string hint;
  EXPECT_NE(FindKey(*program, "limit", hint), kNoSlot);
  ScenarioPlayer player(*program, {});
  EXPECT_TRUE(player.UnplayedNodes().empty());
  EXPECT_EQ(player.Play({}).status, Status::kSuccess);
}

TEST(StandIn, OfANodeOfAWellKnownProgramIsWhatThatSays) {
  const auto program =
      Compiled(R"(<BehaviorTree ID="Main"><Sequence><IsStuck/><GoalReached goal="{goal}"/>)"
               R"(<Spin spin_dist="1.57"/><IsStuckToo/></Sequence></BehaviorTree>)");
  ASSERT_TRUE(program);
  EXPECT_EQ(program->registry->Find("IsStuck")->manifest.category, NodeCategory::kCondition);
  EXPECT_EQ(program->registry->Find("Spin")->manifest.category, NodeCategory::kAction);
  EXPECT_EQ(program->registry->Find("IsStuckToo")->manifest.category, NodeCategory::kAction);
}

TEST(StandIn, ADecoratorWithoutModelNeedsAScript) {
  const auto program = Compiled(kGuarded);
  ASSERT_TRUE(program);
  EXPECT_EQ(ScenarioPlayer(*program, {}).UnplayedNodes(), std::vector{kRootNode});
}

TEST(StandIn, ModelsMayComeFromElsewhere) {
  Diagnostics diagnostics;
  const auto tree = Project::FromText(
      R"(<root BTCPP_format="4">)" + std::string(kGuarded) + "</root>", "tree.xml", diagnostics);
  const auto models =
      Project::FromText(R"(<root BTCPP_format="4">)" + std::string(kGuardedModel) + "</root>",
                        "models.xml", diagnostics);
  ASSERT_TRUE(tree && models) << diagnostics.ToString();
  EXPECT_TRUE(NeedsScript(*ScenarioRegistry(*tree)->Find("Guarded")));
  EXPECT_FALSE(NeedsScript(*ScenarioRegistry(*tree, &*models)->Find("Guarded")));
}

TEST(StandIn, ADecoratorCanBePlayedWithItsChild) {
  const auto program =
      Compiled(R"(<BehaviorTree ID="Main"><Guarded><AlwaysSuccess/></Guarded></BehaviorTree>)");
  ASSERT_TRUE(program);
  PlacedRule rule;
  rule.rule.pattern = "<Guarded>";
  rule.rule.script.results = {Status::kFailure};
  ScenarioPlayer player(*program, {rule});
  EXPECT_EQ(player.Play({}).status, Status::kFailure);
}

TEST(StandIn, AModelSaysMore) {
  const auto program =
      Compiled(R"(<BehaviorTree ID="Main"><IsLow level="{battery}"/></BehaviorTree>)"
               R"(<TreeNodesModel><Condition ID="IsLow"><input_port name="level" type="double"/>)"
               "</Condition></TreeNodesModel>");
  ASSERT_TRUE(program);
  const Registry::Entry& entry = *program->registry->Find("IsLow");
  EXPECT_EQ(entry.manifest.category, NodeCategory::kCondition);
  EXPECT_EQ(entry.declarations[0].type, &TypeOf<double>());
}

TEST(StandIn, WhatAScriptWritesHasTheTypeOfTheKey) {
  const auto program =
      Compiled(R"(<BehaviorTree ID="Main"><Sequence><Look seen="{n}"/><Repeat num_cycles="{n}">)"
               "<AlwaysSuccess/></Repeat></Sequence></BehaviorTree>");
  ASSERT_TRUE(program);
  PlacedRule rule;
  rule.rule.pattern = "<Look>";
  rule.rule.script.outputs = {{"seen", "1"}};
  ScenarioPlayer player(*program, {rule});
  EXPECT_EQ(player.Play({}).status, Status::kSuccess);
  rule.rule.script.outputs = {{"seen", "many"}};
  ScenarioPlayer other(*program, {rule});
  const StepOutcome outcome = other.Play({});
  EXPECT_EQ(outcome.status, Status::kFailure);
  ASSERT_EQ(outcome.messages.size(), 1U);
}

TEST(StandIn, ANumberForAKeyWithoutTypeIsANumber) {
  const auto program = Compiled(
      R"(<BehaviorTree ID="Main"><Sequence><Look seen="{n}" day="{day}"/>)"
      R"(<ScriptCondition code="n &gt; 2 &amp;&amp; day == true"/></Sequence></BehaviorTree>)");
  ASSERT_TRUE(program);
  PlacedRule rule;
  rule.rule.pattern = "<Look>";
  rule.rule.script.outputs = {{"seen", "2.5"}, {"day", "true"}};
  ScenarioPlayer player(*program, {rule});
  EXPECT_EQ(player.Play({}).status, Status::kSuccess);
}

}  // namespace
}  // namespace coppice
