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
  const auto low = CompileCondition("battery < 20 && word == 'go'", *stage_.program, kMainScope);
  ASSERT_TRUE(low) << low.problem();
  EXPECT_TRUE(low->Test(blackboard));
  const auto high = CompileCondition("battery > 20", *stage_.program, kMainScope);
  ASSERT_TRUE(high) << high.problem();
  EXPECT_FALSE(high->Test(blackboard));
}

TEST_F(HookConditionTest, SaysWhereItIsWrong) {
  const std::string problem =
      CompileCondition("battery >\n  < 3", *stage_.program, kMainScope).problem();
  EXPECT_THAT(problem, HasSubstr("condition:2:3: "));
}

TEST_F(HookConditionTest, NamesTheNearestKey) {
  const std::string problem = CompileCondition("1 < batery", *stage_.program, kMainScope).problem();
  EXPECT_THAT(problem, HasSubstr("condition:1:5: "));
  EXPECT_THAT(problem, HasSubstr(R"(did you mean "battery"?)"));
}

TEST_F(HookConditionTest, CannotWrite) {
  const std::string problem =
      CompileCondition("battery = 3", *stage_.program, kMainScope).problem();
  EXPECT_THAT(problem, HasSubstr("cannot assign"));
}

TEST_F(HookConditionTest, MayNameAnythingInAPlaceThatThereIsNotYet) {
  EXPECT_EQ(CheckCondition("unknown > 3", {}).problem(), "");
  EXPECT_NE(CheckCondition("unknown >", {}).problem(), "");
}

}  // namespace
}  // namespace coppice
