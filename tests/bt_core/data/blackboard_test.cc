#include "bt_core/data/blackboard.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

Layout TwoScopes() {
  Layout layout;
  layout.scopes = {"Main", "Main/Inner"};
  layout.slots = {{"speed", kMainScope, &TypeOf<double>(), Value()},
                  {"", kMainScope, &TypeOf<int>(), Value(42)},
                  {"speed", ScopeIndex{1}, &TypeOf<int>(), Value()}};
  return layout;
}

TEST(Layout, FindsAKeyInItsScope) {
  const Layout layout = TwoScopes();
  EXPECT_EQ(layout.Find(kMainScope, "speed"), 0U);
  EXPECT_EQ(layout.Find(ScopeIndex{1}, "speed"), 2U);
}

TEST(Layout, DoesNotFindWhatIsNotThere) {
  EXPECT_EQ(TwoScopes().Find(kMainScope, "goal"), kNoSlot);
  EXPECT_EQ(TwoScopes().Find(ScopeIndex{2}, "speed"), kNoSlot);
}

TEST(Layout, LiteralsHaveNoKey) { EXPECT_EQ(TwoScopes().Find(kMainScope, ""), kNoSlot); }

TEST(Blackboard, StartsWithTheLiterals) {
  const Blackboard blackboard = MakeBlackboard(TwoScopes());
  ASSERT_EQ(blackboard.size(), 3U);
  EXPECT_FALSE(blackboard[SlotIndex{0}].value.has_value());
  EXPECT_EQ(blackboard[SlotIndex{1}].value.Get<int>(), 42);
  EXPECT_EQ(blackboard[SlotIndex{1}].writes, 0U);
}

}  // namespace
}  // namespace coppice
