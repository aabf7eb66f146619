#include "bt_core/analysis/play/leaf_scripts.h"

#include <gtest/gtest.h>

#include "bt_core/data/value_bytes.h"
#include "bt_core/testing/stand_in.h"
#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

class LeafScriptsTest : public testing::Test {
 protected:
  LeafScriptsTest() {
    Diagnostics diagnostics;
    const auto project = Project::FromText(
        "<root BTCPP_format='4'>" + std::string(kTree) + "</root>", "t.xml", diagnostics);
    const auto registry = std::make_shared<Registry>(*ScenarioRegistry(*project));
    program_ = CompileText(kTree, registry);
    tree_ = CompileRecorded(DescribeTree(*program_, {}), registry, diagnostics);
  }
  SlotIndex SlotOf(const std::string& key) const {
    for (SlotIndex i{0}; i < tree_.description->slots.size(); ++i) {
      if (tree_.description->slots[i].name == key) return i;
    }
    return kNoSlot;
  }
  // What the writer has gathered, as a step.
  ScenarioStep Read(LeafScripts& scripts) {
    ScenarioStep step;
    TickEvents events{};
    events.words = writer_.words();
    scripts.Read(events, step);
    writer_.Clear();
    return step;
  }
  template <class T>
  static Value Of(T number) {
    Value value;
    value.Set(number);
    return value;
  }

  static constexpr char kTree[] =
      "<BehaviorTree ID='Main'><Sequence><Go name='go' left='{left}'/><Say name='say'/>"
      "<Script name='script' code='n := 1'/></Sequence></BehaviorTree>";
  static constexpr NodeIndex kGo = NodeIndex{1}, kSay = NodeIndex{2}, kScript = NodeIndex{3};
  std::shared_ptr<const Program> program_;
  RecordedTree tree_;
  EventWriter writer_;
};

TEST_F(LeafScriptsTest, ALeafGoesOnAsItDidUntilItDoesSomethingElse) {
  LeafScripts scripts(tree_);
  writer_.Status(kGo, Status::kRunning);
  EXPECT_TRUE(Read(scripts).leaves.empty()) << "that is its script from the start";
  writer_.Status(kGo, Status::kRunning);
  EXPECT_TRUE(Read(scripts).leaves.empty());
  writer_.Status(kGo, Status::kFailure);
  const ScenarioStep step = Read(scripts);
  ASSERT_EQ(step.leaves.size(), 1U);
  EXPECT_EQ(step.leaves[0].rule.pattern, "go");
  EXPECT_EQ(step.leaves[0].rule.script.results, std::vector<Status>{Status::kFailure});
  const std::vector<PlacedRule> rules = scripts.Rules();
  ASSERT_EQ(rules.size(), 2U) << "built-in nodes need none";
  EXPECT_EQ(rules[0].rule.script.results, std::vector<Status>{Status::kRunning});
  EXPECT_EQ(rules[1].rule.script.results, std::vector<Status>{Status::kSuccess}) << "never ticked";
}

TEST_F(LeafScriptsTest, SeveralResultsInATickAreAList) {
  LeafScripts scripts(tree_);
  writer_.Status(kGo, Status::kFailure);
  writer_.Status(kGo, Status::kSuccess);
  Read(scripts);
  const std::vector<Status> both = {Status::kFailure, Status::kSuccess};
  EXPECT_EQ(scripts.Rules()[0].rule.script.results, both);
  writer_.Status(kGo, Status::kSuccess);
  EXPECT_TRUE(Read(scripts).leaves.empty()) << "the last one repeats";
}

TEST_F(LeafScriptsTest, WhatALeafWroteIsFeedbackOrOutput) {
  LeafScripts scripts(tree_);
  writer_.Write(SlotOf("left"), kGo, Of(2.5));
  writer_.Status(kGo, Status::kRunning);
  Read(scripts);
  using Ports = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(scripts.Rules()[0].rule.script.feedback, (Ports{{"left", "2.5"}}));
  writer_.Write(SlotOf("left"), kGo, Of(0.0));
  writer_.Status(kGo, Status::kSuccess);
  const ScenarioStep step = Read(scripts);
  ASSERT_EQ(step.leaves.size(), 1U);
  EXPECT_EQ(step.leaves[0].rule.script.outputs, (Ports{{"left", "0"}}));
  EXPECT_TRUE(step.set.empty());
}

TEST_F(LeafScriptsTest, WhatCameFromOutsideIsSetAndWhatNodesWriteIsNot) {
  LeafScripts scripts(tree_);
  writer_.Delivery(SlotOf("left"), Of(7.0));
  writer_.Delivery(SlotOf("left"), Of(8.0));
  writer_.Write(SlotOf("n"), kScript, Of(std::int64_t{1}));
  const ScenarioStep step = Read(scripts);
  ASSERT_EQ(step.set.size(), 1U);
  EXPECT_EQ(step.set[0].key, "left");
  EXPECT_EQ(step.set[0].text, "8") << "the last one counts";
}

TEST_F(LeafScriptsTest, ValuesAreWrittenAsPeopleDo) {
  const auto written = [](const Value& value) {
    std::string bytes;
    AppendValueBytes(value, bytes);
    return KeyValueOf("key", bytes);
  };
  EXPECT_EQ(written(Of(true)).kind, KeyValue::Kind::kBool);
  EXPECT_EQ(written(Of(-2.5)).kind, KeyValue::Kind::kNumber);
  EXPECT_EQ(written(Of(-2.5)).text, "-2.5");
  EXPECT_EQ(written(Of(1.0 / 0.0)).kind, KeyValue::Kind::kString) << "JSON has no infinity";
  EXPECT_EQ(written(Of(std::string("2.5"))).kind, KeyValue::Kind::kString);
}

}  // namespace
}  // namespace coppice
