#include "bt_core/live/debug/hook_condition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

class HookConditionTest : public ::testing::Test {
 protected:
  Stage stage_{Main(R"(<Script code="battery := 17; word := 'go'"/>)")};
};

TEST_F(HookConditionTest, IsComputedOnTheBlackboardOfTheTree) {
  stage_.executor->Tick();
  Blackboard blackboard = stage_.executor->blackboard();
  ConditionProblem problem;
  const auto low = CompileCondition("battery < 20 && word == 'go'", *stage_.program, 0, problem);
  ASSERT_TRUE(low) << problem.text;
  EXPECT_TRUE(low->Test(blackboard));
  const auto high = CompileCondition("battery > 20", *stage_.program, 0, problem);
  ASSERT_TRUE(high) << problem.text;
  EXPECT_FALSE(high->Test(blackboard));
}

TEST_F(HookConditionTest, SaysWhereItIsWrong) {
  ConditionProblem problem;
  EXPECT_FALSE(CompileCondition("battery >\n  < 3", *stage_.program, 0, problem));
  EXPECT_THAT(problem.text, HasSubstr("condition:2:3: "));
  EXPECT_EQ(problem.offset, 12u);
}

TEST_F(HookConditionTest, NamesTheNearestKey) {
  ConditionProblem problem;
  EXPECT_FALSE(CompileCondition("1 < batery", *stage_.program, 0, problem));
  EXPECT_THAT(problem.text, HasSubstr("condition:1:5: "));
  EXPECT_THAT(problem.text, HasSubstr(R"(did you mean "battery"?)"));
  EXPECT_EQ(problem.offset, 4u);
}

TEST_F(HookConditionTest, CannotWrite) {
  ConditionProblem problem;
  EXPECT_FALSE(CompileCondition("battery = 3", *stage_.program, 0, problem));
  EXPECT_THAT(problem.text, HasSubstr("cannot assign"));
}

TEST_F(HookConditionTest, MayNameAnythingInAPlaceThatThereIsNotYet) {
  EXPECT_EQ(CheckCondition("unknown > 3", {}).text, "");
  EXPECT_NE(CheckCondition("unknown >", {}).text, "");
}

}  // namespace
}  // namespace coppice
