// Some ten thousand mutated inputs, the same in every run. What must not happen is a crash, which
// is why this is worth most under -DCOPPICE_SANITIZE=address,undefined.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/history/frame.h"
#include "bt_core/history/payload_coding.h"
#include "bt_core/history/tick_coding.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutator.h"

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

void AppendFrame(FrameType type, const Bytes& payload, std::string& out) {
  out += static_cast<char>(type);
  out += static_cast<char>(payload.size() & 0xff);
  out += static_cast<char>(payload.size() >> 8);
  out.append(payload.begin(), payload.end());
}

// A tree of two nodes and a slot, how it stands, and some ticks.
std::string SomeHistory() {
  TreeDescription tree;
  tree.documents = {{"a.xml", "<root/>"}};
  tree.nodes.resize(2);
  tree.nodes[1].path = "top";
  tree.nodes[1].ports = {{"port", 0}};
  tree.slots.resize(1);
  std::string history;
  Bytes payload;
  Encoder out(payload);
  EncodeTree(tree, out);
  AppendFrame(FrameType::kTree, payload, history);
  payload.clear();
  const HistoryState state{{}, 1, Time(1), {{}, {}}, {{}, {}}, {"\1text"}};
  EncodeStateHead(state, out);
  EncodeStateBody(state, out);
  AppendFrame(FrameType::kState, payload, history);
  TickEncoder ticks;
  EventWriter words;
  words.Add(EventCode::kWrite, 0, 1, "\1new");
  words.Text(1, EventText::kMessage, "because");
  words.Status(1, Status::kSuccess);
  words.Status(0, Status::kRunning);
  for (std::uint64_t i = 2; i < 5; ++i) {
    payload.clear();
    ticks.Encode({i, Time(1000 * i), Duration(0), Status::kRunning, true, words.words()}, payload);
    AppendFrame(FrameType::kEvents, payload, history);
  }
  return history;
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

// What once crashed a harness must not do so again: regressions/NAME/* are inputs of FuzzName.
TEST(Fuzz, WhatOnceCrashedDoesNotAnyMore) {
  const std::pair<const char*, int (*)(std::string_view)> harnesses[] = {
      {"document", FuzzDocument}, {"edit", FuzzEdit},         {"history", FuzzHistory},
      {"literal", FuzzLiteral},   {"scenario", FuzzScenario}, {"script", FuzzScript}};
  for (const auto& [name, harness] : harnesses) {
    const auto folder = std::filesystem::path(COPPICE_SOURCE_DIR "/tests/fuzz/regressions") / name;
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& input : std::filesystem::directory_iterator(folder)) {
      SCOPED_TRACE(input.path());
      std::ifstream file(input.path(), std::ios::binary);
      harness(std::string(std::istreambuf_iterator<char>(file), {}));
    }
  }
}

TEST(Fuzz, EmptyInputIsFine) {
  EXPECT_EQ(FuzzDocument(""), 0);
  EXPECT_EQ(FuzzHistory(""), 0);
  EXPECT_EQ(FuzzLiteral(""), 2) << "a text and an empty list";
  EXPECT_EQ(FuzzScenario(""), 0);
  EXPECT_EQ(FuzzScript(""), 0);
}

}  // namespace
}  // namespace coppice::fuzz
