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
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Sequence><IsDay/>"
        "<Condition ID=\"Dry\"/><Island/><AlwaysSuccess/></Sequence></BehaviorTree></root>",
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

}  // namespace
}  // namespace coppice
