#include "bt_core/live/debug/scope_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

class ScopeKeysTest : public ::testing::Test {
 protected:
  Stage stage_{Root(R"(
      <BehaviorTree ID="Main"><Sequence>
        <Script code="battery := 1; text := 'x'"/>
        <SubTree ID="Inner" name="one" level="{battery}" speed="7"/>
        <SubTree ID="Inner" name="two" _autoremap="true"/>
      </Sequence></BehaviorTree>
      <BehaviorTree ID="Inner"><Sequence>
        <Script code="own := level; _mine := 1; level := speed"/>
        <SubTree ID="Deep" name="deep" depth="{level}"/>
      </Sequence></BehaviorTree>
      <BehaviorTree ID="Deep"><Script code="depth := @battery"/></BehaviorTree>)")};
  const Program& program_ = *stage_.program;

  // "SCOPE KEY" of the slot.
  std::string Slot(std::uint32_t scope, std::string_view key) {
    const SlotIndex slot = FindKey(program_, ScopeIndex(scope), key);
    if (slot == kNoSlot) return "none";
    const SlotDefinition& definition = program_.layout.slots[slot];
    return program_.layout.scopes[definition.scope] + " " + definition.key;
  }
};

TEST_F(ScopeKeysTest, KeysOfTheMainTreeAreFoundByName) {
  EXPECT_EQ(Slot(kMainScope, "battery"), "Main battery");
  EXPECT_EQ(Slot(kMainScope, "@battery"), "Main battery");
  EXPECT_EQ(Slot(kMainScope, "level"), "Main level");  // the autoremapped one
  EXPECT_EQ(Slot(kMainScope, "nothing"), "none");
  EXPECT_EQ(Slot(kMainScope, ""), "none");
}

TEST_F(ScopeKeysTest, RemappedKeysAreThoseOutside) {
  ASSERT_EQ(program_.trees[1].path, "one");
  EXPECT_EQ(Slot(1, "level"), "Main battery");
  EXPECT_EQ(Slot(1, "speed"), "one speed");
  EXPECT_EQ(Slot(1, "own"), "one own");
  EXPECT_EQ(Slot(1, "text"), "none");
  EXPECT_EQ(Slot(1, "@text"), "Main text");
}

TEST_F(ScopeKeysTest, RemappingsAreFollowedThroughSeveralTrees) {
  ASSERT_EQ(program_.trees[2].path, "one/deep");
  EXPECT_EQ(Slot(2, "depth"), "Main battery");
}

TEST_F(ScopeKeysTest, AutoremappedKeysAreThoseOfTheParentButForPrivateOnes) {
  ASSERT_EQ(program_.trees[3].path, "two");
  EXPECT_EQ(Slot(3, "text"), "Main text");
  EXPECT_EQ(Slot(3, "own"), "Main own");
  EXPECT_EQ(Slot(3, "_mine"), "two _mine");
}

TEST(ScopeKeys, DefaultsOfAModelDoNotCountBesideAutoremap) {
  const Stage stage(Root(R"(
      <BehaviorTree ID="Main"><Sequence>
        <Script code="level := 1; speed := 2"/><SubTree ID="S" _autoremap="true"/>
      </Sequence></BehaviorTree>
      <BehaviorTree ID="S"><AlwaysSuccess/></BehaviorTree>
      <TreeNodesModel><SubTree ID="S"><input_port name="speed" default="{level}"/></SubTree>
      </TreeNodesModel>)"));
  const SlotIndex slot = FindKey(*stage.program, ScopeIndex{1}, "speed");
  ASSERT_NE(slot, kNoSlot);
  EXPECT_EQ(stage.program->layout.slots[slot].key, "speed");
}

TEST_F(ScopeKeysTest, HintsNameWhatIsVisible) {
  EXPECT_THAT(KeysAround(program_, ScopeIndex{1}),
              ::testing::IsSupersetOf({"speed", "own", "_mine", "level"}));
}

}  // namespace
}  // namespace coppice
