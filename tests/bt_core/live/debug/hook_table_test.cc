#include "bt_core/live/debug/hook_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class HookTableTest : public ::testing::Test {
 protected:
  static Hook At(NodeIndex node) {
    Hook hook;
    hook.node = node;
    return hook;
  }
  static Hook AtPath(const std::string& path) {
    Hook hook;
    hook.path = path;
    return hook;
  }

  Stage stage_{Main(R"(<Sequence><Leaf name="a"/><Leaf name="b" _skipIf="level &lt; 5"/>)"
                    R"(<Leaf name="a"/></Sequence>)")};
  HookTable table_{stage_.program};
};

TEST_F(HookTableTest, FindsHooksByNodeAndPositionThoseThatStopFirst) {
  Hook replace = At(NodeIndex{1});
  replace.action = HookAction::kReplace;
  const HookId first = table_.Add(replace, 0)->id;
  const HookId second = table_.Add(At(NodeIndex{1}), 0)->id;
  Hook after = At(NodeIndex{1});
  after.position = HookPosition::kAfter;
  const HookId third = table_.Add(after, 0)->id;
  EXPECT_THAT(table_.At(NodeIndex{1}, HookPosition::kBefore), ElementsAre(second, first));
  EXPECT_THAT(table_.At(NodeIndex{1}, HookPosition::kAfter), ElementsAre(third));
  EXPECT_THAT(table_.At(NodeIndex{2}, HookPosition::kBefore), IsEmpty());
  EXPECT_THAT(table_.Nodes(), ElementsAre(1u));
  EXPECT_TRUE(table_.Remove(second));
  EXPECT_FALSE(table_.Remove(second));
  EXPECT_THAT(table_.At(NodeIndex{1}, HookPosition::kBefore), ElementsAre(first));
}

TEST_F(HookTableTest, TakesAllNodesOfAPath) {
  const Expected<HookAnswer> answer = table_.Add(AtPath("Main/a"), 0);
  EXPECT_EQ(answer->remark, "");
  EXPECT_THAT(table_.Nodes(), ElementsAre(1u, 3u));
}

TEST_F(HookTableTest, KnowsWhoseAHookIs) {
  EXPECT_TRUE(table_.Add(At(NodeIndex{1}), 5));
  const HookId second = table_.Add(At(NodeIndex{2}), 6)->id;
  EXPECT_THAT(table_.IdsOf(6), ElementsAre(second));
}

TEST_F(HookTableTest, CountsAnewWhenAHookIsChanged) {
  const HookId id = table_.Add(At(NodeIndex{1}), 5)->id;
  table_.Find(id)->info.hits = 3;
  ASSERT_TRUE(table_.Change(id, At(NodeIndex{2})).ok());
  EXPECT_EQ(table_.Find(id)->info.hits, 0u);
  EXPECT_EQ(table_.Find(id)->info.owner, 5u);
  EXPECT_THAT(table_.Nodes(), ElementsAre(2u));
  EXPECT_THAT(table_.Change(HookId{99}, At(NodeIndex{2})).problem(), HasSubstr("no hook 99"));
}

struct WrongHook {
  const char* name;
  std::function<void(Hook&)> change;
  const char* problem;
};

class HookTableRefuses : public HookTableTest, public ::testing::WithParamInterface<WrongHook> {};

TEST_P(HookTableRefuses, WhatIsWrong) {
  Hook hook = At(NodeIndex{2});
  GetParam().change(hook);
  const Expected<HookAnswer> answer = table_.Add(hook, 0);
  EXPECT_FALSE(answer.ok());
  EXPECT_THAT(answer.problem(), HasSubstr(GetParam().problem));
  EXPECT_THAT(table_.entries(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, HookTableRefuses,
    ::testing::Values(
        WrongHook{"NoNode", [](Hook& h) { h.node = kNoNode; }, "needs a node or a path"},
        WrongHook{"NodeOutOfRange", [](Hook& h) { h.node = NodeIndex{4}; }, "the nodes 0 to 3"},
        WrongHook{"IdleIsNoResult",
                  [](Hook& h) {
                    h.action = HookAction::kReplace;
                    h.status = Status::kIdle;
                  },
                  "IDLE is no result"},
        WrongHook{"DelayAfterwards",
                  [](Hook& h) {
                    h.action = HookAction::kDelay;
                    h.position = HookPosition::kAfter;
                  },
                  "only before"},
        WrongHook{"NoDelay", [](Hook& h) { h.action = HookAction::kDelay; }, "longer than 0"},
        WrongHook{"HitZero", [](Hook& h) { h.from_hit = 0; }, "counted from 1"},
        WrongHook{"ConditionThatCannotBeRead", [](Hook& h) { h.condition = "level >"; },
                  "condition:1:"},
        WrongHook{"ConditionWithAnUnknownKey", [](Hook& h) { h.condition = "levle > 2"; },
                  R"(did you mean "level"?)"},
        WrongHook{"UnreadableConditionOfANodeThatIsNotThereYet",
                  [](Hook& h) {
                    h.path = "later";
                    h.condition = "(1";
                  },
                  "condition:1:"}),
    [](const auto& info) { return info.param.name; });

TEST_F(HookTableTest, RefusesMoreHooksThanItsLimit) {
  for (std::size_t i = 0; i < HookTable::kMaxHooks; ++i)
    ASSERT_TRUE(table_.Add(AtPath("x"), 0).ok());
  EXPECT_FALSE(table_.Add(At(NodeIndex{1}), 0).ok());
}

TEST_F(HookTableTest, RefusesTextsThatAreTooLongTogether) {
  const std::string half(HookTable::kMaxTextBytes / 2, 'x');
  const HookId first = table_.Add(AtPath(half), 0)->id;
  ASSERT_TRUE(table_.Add(AtPath(half.substr(2)), 0));
  EXPECT_THAT(table_.Add(AtPath("abc"), 0).problem(), HasSubstr("too long"));
  EXPECT_TRUE(table_.Change(first, AtPath(half)));
  EXPECT_THAT(table_.Change(first, AtPath(half + "abc")).problem(), HasSubstr("too long"));
  EXPECT_EQ(table_.Find(first)->info.hook.path, half);
}

TEST_F(HookTableTest, RefusesToBeAtMoreNodesThanItsLimit) {
  constexpr std::size_t kNodes = 100'000;
  std::string leaves;
  for (std::size_t i = 0; i < kNodes; ++i) leaves += "<Leaf/>";
  const Stage large(Main("<Sequence>" + leaves + "</Sequence>"));
  HookTable table(large.program);
  for (std::size_t i = 0; i < HookTable::kMaxPlaces / kNodes; ++i) {
    ASSERT_TRUE(table.Add(AtPath("Leaf"), 0));
  }
  EXPECT_THAT(table.Add(AtPath("Leaf"), 0).problem(), HasSubstr("nodes"));
  EXPECT_THAT(table.Add(At(NodeIndex{1}), 0).problem(), HasSubstr("nodes"));
  Stage small(Main("<Leaf/>"));
  table.SetProgram(small.program);
  EXPECT_TRUE(table.Add(At(NodeIndex{0}), 0));
}

TEST_F(HookTableTest, FollowsASwapOfTheTree) {
  Hook conditional = AtPath("c");
  conditional.condition = "fuel > 1";
  const HookId waits = table_.Add(conditional, 0)->id;
  const HookId numbered = table_.Add(At(NodeIndex{2}), 0)->id;
  Hook lost = AtPath("b");
  lost.condition = "level > 1";
  const HookId no_longer_fits = table_.Add(lost, 0)->id;
  Stage next(
      Main(R"(<Sequence><Leaf name="b"/><Leaf name="c" _skipIf="fuel &lt; 1"/></Sequence>)"));
  table_.SetProgram(next.program);
  EXPECT_THAT(table_.Find(waits)->info.nodes, ElementsAre(2u));
  EXPECT_TRUE(table_.Find(waits)->condition);
  EXPECT_THAT(table_.Find(numbered)->info.nodes, ElementsAre(1u));
  EXPECT_THAT(table_.Find(no_longer_fits)->info.nodes, IsEmpty());
  EXPECT_THAT(table_.Find(no_longer_fits)->info.problem, HasSubstr(R"("level")"));
}

}  // namespace
}  // namespace coppice
