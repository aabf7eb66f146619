#include "bt_core/testing/default_leaves.h"

#include <gtest/gtest.h>

#include "tests/bt_core/testing/with_stand_ins.h"

namespace coppice {
namespace {

class DefaultLeavesTest : public testing::Test {
 protected:
  DefaultLeavesTest() {
    Diagnostics diagnostics;
    program_ = CompileWithStandIns(
        R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence><IsDay/>)"
        R"(<Condition ID="Dry"/><Island/><AlwaysSuccess/></Sequence></BehaviorTree></root>)",
        diagnostics);
  }
  std::shared_ptr<const Program> program_;
};

TEST_F(DefaultLeavesTest, ConditionsAreTrueAndActionsTakeASecond) {
  const std::vector<PlacedRule> rules = DefaultLeaves(*program_);
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_EQ(rules[0].rule.pattern, "<Dry>");
  EXPECT_EQ(rules[0].rule.script.duration, Duration(0));
  EXPECT_EQ(rules[1].rule.pattern, "<IsDay>");
  EXPECT_EQ(rules[1].rule.script.duration, Duration(0));
  EXPECT_EQ(rules[2].rule.script.duration, std::chrono::seconds(1)) << "an island is no condition";
}

TEST_F(DefaultLeavesTest, ByChanceConditionsTakeNoTimeAndActionsMayFail) {
  const std::vector<PlacedRule> rules = RandomLeaves(*program_);
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_EQ(rules[0].rule.script.chances->longest, Duration(0));
  EXPECT_EQ(rules[2].rule.script.chances->longest, std::chrono::seconds(2));
  EXPECT_GT(rules[2].rule.script.chances->failure, 0);
}

TEST_F(DefaultLeavesTest, ByChanceConditionsStayWhatTheyAreForSomeSeconds) {
  EXPECT_EQ(RandomLeaves(*program_)[0].rule.script.chances->longest_hold, std::chrono::seconds(5));
}

TEST_F(DefaultLeavesTest, WhatIsGivenComesFirstAndAloneForItsTypes) {
  const std::vector<PlacedRule> rules =
      RandomLeaves(*program_, {{{}, {"dry", {}}}, {{}, {"<Is*>", {}}}});
  std::string patterns;
  for (const PlacedRule& rule : rules) patterns += rule.rule.pattern + " ";
  EXPECT_EQ(patterns, "dry <Is*> <Dry> ") << "IsDay and Island are <Is*>";
}

TEST(RandomLeaves, OutputsGetValuesOfTheirTypes) {
  Diagnostics diagnostics;
  const auto program = CompileWithStandIns(
      R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
         <Look a="{a}" b="{b}" c="{c}" d="{d}" e="{e}" f="{f}"/></BehaviorTree>
         <TreeNodesModel><Action ID="Look"><output_port name="a" type="bool"/>
         <output_port name="b" type="int" default="7"/><output_port name="c" type="double"/>
         <output_port name="d" type="string"/><output_port name="e" type="Pose"/>
         <input_port name="f" type="int"/></Action></TreeNodesModel></root>)",
      diagnostics);
  ASSERT_TRUE(program) << diagnostics.ToString();
  using Texts = std::vector<std::string>;
  const auto outputs = RandomLeaves(*program).at(0).rule.script.outputs_by_chance;
  ASSERT_EQ(outputs.size(), 4U) << "nobody knows what a Pose is, and f is an input";
  EXPECT_EQ(outputs[0], std::pair(std::string("a"), Texts({"true", "false"})));
  EXPECT_EQ(outputs[1], std::pair(std::string("b"), Texts({"7", "0", "1", "2"})));
  EXPECT_EQ(outputs[2], std::pair(std::string("c"), Texts({"0", "0.5", "1", "2"})));
  EXPECT_EQ(outputs[3], std::pair(std::string("d"), Texts({"d"})));
}

}  // namespace
}  // namespace coppice
