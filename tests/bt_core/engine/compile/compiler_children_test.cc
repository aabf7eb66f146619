#include "bt_core/engine/compile/compiler_children.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(WrongChildCount, IsEmptyIfTheNumberIsRight) {
  EXPECT_EQ(WrongChildCount("A", 0, {0, 0}), "");
  EXPECT_EQ(WrongChildCount("A", 3, {2, 3}), "");
  EXPECT_EQ(WrongChildCount("A", 100, {1, UINT32_MAX}), "");
}

TEST(WrongChildCount, SaysWhatIsExpected) {
  EXPECT_EQ(WrongChildCount("A", 1, {0, 0}), "A has 1 child, expected none");
  EXPECT_EQ(WrongChildCount("A", 2, {1, 1}), "A has 2 children, expected exactly 1");
  EXPECT_EQ(WrongChildCount("A", 1, {2, 3}), "A has 1 child, expected 2 or 3");
  EXPECT_EQ(WrongChildCount("A", 9, {2, 7}), "A has 9 children, expected 2 to 7");
  EXPECT_EQ(WrongChildCount("A", 1, {2, UINT32_MAX}), "A has 1 child, expected at least 2");
}

TEST(ChildrenOf, FollowsTheCategory) {
  EXPECT_EQ(ChildrenOf(NodeCategory::kAction).max, 0U);
  EXPECT_EQ(ChildrenOf(NodeCategory::kCondition).max, 0U);
  EXPECT_EQ(ChildrenOf(NodeCategory::kDecorator).max, 1U);
  EXPECT_EQ(ChildrenOf(NodeCategory::kControl).min, 1U);
}

}  // namespace
}  // namespace coppice
