#include "bt_core/data/blackboard.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

Layout TwoScopes() {
  Layout layout;
  layout.scopes = {"Main", "Main/Inner"};
  layout.slots = {{"speed", 0, &TypeOf<double>(), Value()},
                  {"", 0, &TypeOf<int>(), Value(42)},
                  {"speed", 1, &TypeOf<int>(), Value()}};
  return layout;
}

TEST(Layout, FindsAKeyInItsScope) {
  const Layout layout = TwoScopes();
  EXPECT_EQ(layout.Find(0, "speed"), 0U);
  EXPECT_EQ(layout.Find(1, "speed"), 2U);
}

TEST(Layout, DoesNotFindWhatIsNotThere) {
  EXPECT_EQ(TwoScopes().Find(0, "goal"), kNoSlot);
  EXPECT_EQ(TwoScopes().Find(2, "speed"), kNoSlot);
}

TEST(Layout, LiteralsHaveNoKey) { EXPECT_EQ(TwoScopes().Find(0, ""), kNoSlot); }

TEST(Blackboard, StartsWithTheLiterals) {
  const Blackboard blackboard = MakeBlackboard(TwoScopes());
  ASSERT_EQ(blackboard.size(), 3U);
  EXPECT_FALSE(blackboard[0].value.has_value());
  EXPECT_EQ(blackboard[1].value.Get<int>(), 42);
  EXPECT_EQ(blackboard[1].writes, 0U);
}

}  // namespace
}  // namespace coppice
