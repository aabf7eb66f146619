#include "bt_nodes/basics/action_result.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

TEST(ActionResult, ReadsBackWhatItPrints) {
  for (const ActionResult& result : {ActionResult{true, ""}, ActionResult{false, "no path to goal"},
                                     ActionResult{true, "slow"}}) {
    ActionResult read;
    ASSERT_TRUE(ValueTraits<ActionResult>::Parse(ValueTraits<ActionResult>::Print(result), read));
    EXPECT_EQ(read.ok, result.ok);
    EXPECT_EQ(read.message, result.message);
  }
}

TEST(ActionResult, RefusesOtherText) {
  ActionResult result;
  EXPECT_FALSE(ValueTraits<ActionResult>::Parse("okay", result));
  EXPECT_FALSE(ValueTraits<ActionResult>::Parse("", result));
}

}  // namespace
}  // namespace coppice::leaves
