// Some ten thousand mutated inputs, the same in every run. What must not happen is a crash, which
// is why this is worth most under -DCOPPICE_SANITIZE=address,undefined.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/regressions.h"
#include "tests/fuzz/seeds.h"

namespace coppice::fuzz {
namespace {

constexpr const char* kTree = R"(<?xml version="1.0"?>
<!-- patrol -->
<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <ReactiveFallback name="top">
      <Timeout msec="250"><SubTree ID="Inner" a="{b}" c="5" _autoremap="true"/></Timeout>
      <Parallel success_count="-1" failure_count="{n}"><AlwaysSuccess/><Leaf/></Parallel>
      <Repeat num_cycles="3"><Action ID="Any" x="&lt;&#65;"/></Repeat>
    </ReactiveFallback>
  </BehaviorTree>
  <BehaviorTree ID="Inner">
    <Sequence _skipIf="a &gt; 1">
      <Delay delay_msec="{a}"><Inverter><AlwaysFailure/></Inverter></Delay>
    <![CDATA[ text ]]></Sequence>
  </BehaviorTree>
  <TreeNodesModel/>
</root>
)";

TEST(Fuzz, MutatedTreesNeverCrash) {
  EXPECT_EQ(FuzzDocument(kTree), 3);
  int reached[4] = {};
  for (unsigned seed = 0; seed < 20000; ++seed) {
    ++reached[FuzzDocument(Mutator(seed).Mutate(kTree))];
  }
  for (const int count : reached) EXPECT_GT(count, 50) << "every stage must be reached";
}

constexpr const char* kTree3 = R"(<root main_tree_to_execute="M">
  <!-- format 3 -->
  <BehaviorTree ID="M">
    <SequenceStar name="s"> <!-- c -->
      <SubTree ID="T" a="b" __shared_blackboard="true"/>
      <BlackboardCheckInt value_A="{x}" value_B="3"
                          return_on_mismatch="SUCCESS">
        <SubTreePlus ID="T" __autoremap="1"></SubTreePlus>
      </BlackboardCheckInt>
      <Parallel threshold="2"><A/><![CDATA[ < ]]><B x='a &lt; b && c'/></Parallel>
    </SequenceStar>
  </BehaviorTree>
</root>
)";

TEST(Fuzz, EditsOfMutatedTreesCanBeUndone) {
  int reached[6] = {};
  for (unsigned seed = 0; seed < 20000; ++seed) {
    std::mt19937 random(seed);
    std::string choices;
    for (int i = 0; i < 16; ++i) choices += static_cast<char>(random() % 256);
    const std::string text = seed % 2 == 0 ? kTree : kTree3;
    ++reached[FuzzEdit(choices + Mutator(seed).Mutate(text))];
  }
  EXPECT_GT(reached[0], 1000) << "some are no XML";
  EXPECT_GT(reached[5], 1000) << "many take all edits";
}

TEST(Fuzz, MutatedHistoriesNeverCrash) {
  const std::string history = SomeHistory();
  EXPECT_EQ(FuzzHistory(history), 3);
  int reached[4] = {};
  for (unsigned seed = 0; seed < 20000; ++seed) {
    ++reached[FuzzHistory(Mutator(seed).Mutate(history))];
  }
  for (const int count : reached) EXPECT_GT(count, 50) << "every stage must be reached";
}

TEST(Fuzz, MutatedLiteralsNeverCrash) {
  const char* const kLiterals[] = {"true", "-2147483648", "18446744073709551615", "1.5e-300",
                                   "0x1p-1074"};
  int accepted = 0;
  for (unsigned seed = 0; seed < 5000; ++seed) {
    accepted += FuzzLiteral(Mutator(seed).Mutate(kLiterals[seed % 5]));
  }
  EXPECT_GT(accepted, 5000);
}

TEST(Fuzz, MutatedScriptsNeverCrash) {
  const char* const kScripts[] = {
      "a := d > 20 && !b ? 'yes' : s .. 1.5; i += 1; a == s",
      "e == SUCCESS || e != 'FAILURE' && (u & 0x1F) < 7 < f; v == '1;2'",
      "a := clamp(min(d, 3), -1, abs(i)) % 7; s = s + 'it\\'s'; ~u ^ 3 | i",
      "x := y := d / 2 - -i; x *= 3; y -= f; s .. (s := 'new'); !(x < y)",
      "v := '1;2'; e := RUNNING; @root := true; i = 7 u = 8; a"};
  int reached[3] = {};
  for (const char* script : kScripts) EXPECT_GE(FuzzScript(script), 1) << script;
  for (unsigned seed = 0; seed < 30000; ++seed) {
    ++reached[FuzzScript(Mutator(seed).Mutate(kScripts[seed % 5]))];
  }
  for (const int count : reached) EXPECT_GT(count, 500) << "every stage must be reached";
}

TEST(Fuzz, MutatedScenariosNeverCrash) {
  constexpr const char* kScenarios = R"({
  "tree": "x.xml", "leaves": {"<Go>": ["RUNNING", "SUCCESS"], "a": {"after_ms": 20, "says": "x"}},
  "scenarios": [{"name": "one", "steps": [
    {"set": {"n": 3, "g": 1.5}, "expect": {"status": "RUNNING", "nodes": {"top": "RUNNING"}}},
    {"advance_ms": 20, "ticks": 2, "leaves": {"b": "SKIPPED"},
     "expect": {"events": [["tick", "a", "SUCCESS", {"g": "1.5"}], ["halt", "b"]],
                "blackboard": {"n": 3}, "messages": ["x"]}},
    {"halt": true}]}]})";
  EXPECT_EQ(FuzzScenario(kScenarios), 2);
  int played = 0;
  for (unsigned seed = 0; seed < 5000; ++seed) {
    played += FuzzScenario(Mutator(seed).Mutate(kScenarios)) == 2;
  }
  EXPECT_GT(played, 20);
}

TEST(Fuzz, MutatedRecordsNeverCrash) {
  const std::string record = SomeRecord();
  EXPECT_EQ(FuzzRecord(record), 2);
  int reached[3] = {};
  for (unsigned seed = 0; seed < 5000; ++seed) {
    ++reached[FuzzRecord(Mutator(seed).Mutate(record))];
  }
  for (const int count : reached) EXPECT_GT(count, 50) << "every stage must be reached";
}

TEST(Fuzz, MutatedLogsOfBehaviorTreeCppNeverCrash) {
  const std::string log = SomeBtlog();
  EXPECT_EQ(FuzzBtlog(log), 2);
  int reached[3] = {};
  for (unsigned seed = 0; seed < 5000; ++seed) {
    ++reached[FuzzBtlog(Mutator(seed).Mutate(log))];
  }
  for (const int count : reached) EXPECT_GT(count, 5) << "every stage must be reached";
}

TEST(Fuzz, WhatOnceCrashedDoesNotAnyMore) {
  RunRegressions("btlog", FuzzBtlog);
  RunRegressions("document", FuzzDocument);
  RunRegressions("edit", FuzzEdit);
  RunRegressions("history", FuzzHistory);
  RunRegressions("literal", FuzzLiteral);
  RunRegressions("record", FuzzRecord);
  RunRegressions("scenario", FuzzScenario);
  RunRegressions("script", FuzzScript);
}

TEST(Fuzz, EmptyInputIsFine) {
  EXPECT_EQ(FuzzBtlog(""), 0);
  EXPECT_EQ(FuzzDocument(""), 0);
  EXPECT_EQ(FuzzHistory(""), 0);
  EXPECT_EQ(FuzzLiteral(""), 2) << "a text and an empty list";
  EXPECT_EQ(FuzzRecord(""), 0);
  EXPECT_EQ(FuzzScenario(""), 0);
  EXPECT_EQ(FuzzScript(""), 0);
}

}  // namespace
}  // namespace coppice::fuzz
