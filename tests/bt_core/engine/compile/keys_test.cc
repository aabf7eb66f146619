// The table of keys by itself; what it means for trees is in subtree_test.cc.
#include "bt_core/engine/compile/keys.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

struct KeyTableTest : testing::Test {
  Layout layout;
  KeyTable keys{layout};
  const ScopeIndex main = keys.AddScope(kMainScope, false);
};

TEST_F(KeyTableTest, AKeyIsOneSlotPerScope) {
  const ScopeIndex inner = keys.AddScope(main, false);
  const SlotIndex slot = keys.Resolve("k", main);
  EXPECT_EQ(keys.Resolve("k", main), slot);
  EXPECT_NE(keys.Resolve("k", inner), slot);
  EXPECT_EQ(layout.slots[slot].key, "k");
}

TEST_F(KeyTableTest, AutoremapGoesUpThroughAllScopesThatHaveIt) {
  const ScopeIndex outer = keys.AddScope(main, true);
  const ScopeIndex inner = keys.AddScope(outer, true);
  EXPECT_EQ(keys.Resolve("k", inner), keys.Resolve("k", main));
  EXPECT_NE(keys.Resolve("_k", inner), keys.Resolve("_k", outer));
}

TEST_F(KeyTableTest, AskingForAKeyMakesNone) {
  const ScopeIndex inner = keys.AddScope(main, true);
  EXPECT_FALSE(keys.Has("k", inner));
  EXPECT_FALSE(keys.Has("k", main));
  keys.Resolve("k", main);
  EXPECT_TRUE(keys.Has("k", main));
  EXPECT_TRUE(keys.Has("k", inner));
  EXPECT_EQ(layout.slots.size(), 1U);
}

TEST_F(KeyTableTest, AtSignIsTheMainTreeFromEverywhere) {
  const ScopeIndex inner = keys.AddScope(main, false);
  EXPECT_EQ(keys.Resolve("@k", inner), keys.Resolve("k", main));
  EXPECT_EQ(keys.Resolve("@k", main), keys.Resolve("k", main));
}

TEST_F(KeyTableTest, OuterKeysAreApartIfTheyAreKept) {
  keys.KeepOuterKeys();
  const ScopeIndex inner = keys.AddScope(main, false);
  EXPECT_EQ(keys.Resolve("@k", inner), keys.Resolve("@k", main));
  EXPECT_NE(keys.Resolve("@k", main), keys.Resolve("k", main));
  EXPECT_EQ(layout.slots[keys.Resolve("@k", inner)].key, "@k");
}

TEST_F(KeyTableTest, AutoremapEndsAtAKeyThatIsRemapped) {
  const ScopeIndex outer = keys.AddScope(main, true);
  const ScopeIndex inner = keys.AddScope(outer, true);
  const SlotIndex other = keys.Resolve("other", main);
  keys.Bind("k", outer, other);
  EXPECT_EQ(keys.Resolve("k", inner), other);
  EXPECT_NE(keys.Resolve("k", main), other);
}

TEST_F(KeyTableTest, ACopiedKeyIsTheSameKey) {
  std::string name = "k";
  const SlotIndex slot = keys.ResolveCopy(name, main);
  const SlotIndex root = keys.ResolveCopy("@other", main);
  name = "overwritten";
  EXPECT_EQ(keys.Resolve("k", main), slot);
  EXPECT_EQ(keys.Resolve("other", main), root);
}

}  // namespace
}  // namespace coppice
