#include "bt_core/analysis/why/readings.h"

#include <gtest/gtest.h>

#include "bt_core/data/value_bytes.h"
#include "tests/bt_core/analysis/asked_run.h"

namespace coppice {
namespace {

class ReadingsTest : public testing::Test {
 protected:
  void Compile(const std::string& root, std::shared_ptr<Registry> registry = Lamps()) {
    run_.emplace("<BehaviorTree ID='Main'>" + root + "</BehaviorTree>", registry);
    Diagnostics diagnostics;
    tree_ = CompileRecorded(run_->keeper.run.trees()[0], registry, diagnostics);
    EXPECT_EQ(diagnostics.ToString(), "");
  }
  // The values of the keys as the record has them; those that are not named are empty.
  SlotValues Values(const std::vector<std::pair<std::string, double>>& known) const {
    SlotValues values(tree_.description->slots.size());
    for (const auto& [key, number] : known) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (tree_.description->slots[i].name == key) AppendValueBytes(Value(number), values[i]);
      }
    }
    return values;
  }
  std::optional<Status> Decision(bool running, const SlotValues& values) const {
    const auto decision = DecideGuards(tree_, kRootNode, running, values);
    return decision ? std::optional(decision->result) : std::nullopt;
  }

  std::optional<RecordedRun> run_;
  RecordedTree tree_;
};

TEST_F(ReadingsTest, APortThatIsBoundToAKeyIsRead) {
  Compile("<Sequence><Lamp name='bound' lux='{light}'/><Lamp name='literal' lux='3'/></Sequence>");
  const std::vector<Reading> readings = PortReadings(tree_, NodeIndex{1});
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_EQ(readings[0].name, "lux");
  EXPECT_EQ(readings[0].key, "light");
  EXPECT_EQ(tree_.description->slots[readings[0].slot].name, "light");
  EXPECT_TRUE(PortReadings(tree_, NodeIndex{2}).empty()) << "a literal is no key";
  EXPECT_TRUE(PortReadings(tree_, kRootNode).empty());
}

TEST_F(ReadingsTest, ScriptsAreGuardsAndTheCodeOfANode) {
  Compile("<ScriptCondition code='a &lt; b' _skipIf='c == 1'/>");
  const std::vector<NodeScript> scripts = ScriptsOf(tree_, kRootNode);
  ASSERT_EQ(scripts.size(), 2U);
  EXPECT_EQ(scripts[0].attribute, "_skipIf");
  EXPECT_EQ(scripts[0].guard, Guard::kSkipIf);
  EXPECT_EQ(scripts[1].attribute, "code");
  EXPECT_EQ(scripts[1].text, "a < b");
  EXPECT_FALSE(scripts[1].guard);
  std::string keys;
  for (const Reading& reading : ScriptReadings(tree_, scripts[1])) keys += reading.key;
  EXPECT_EQ(keys, "ab");
}

TEST_F(ReadingsTest, AScriptAnswersWithTheValuesOfThatMoment) {
  Compile("<ScriptCondition code='a &lt; b'/>");
  const NodeScript code = ScriptsOf(tree_, kRootNode).at(0);
  EXPECT_EQ(coppice::Test(tree_, code, Values({{"a", 1}, {"b", 2}})), true);
  EXPECT_EQ(coppice::Test(tree_, code, Values({{"a", 2}, {"b", 1}})), false);
  EXPECT_EQ(coppice::Test(tree_, code, Values({{"a", 2}})), std::nullopt)
      << "it throws: b has no value";
}

TEST_F(ReadingsTest, TheFirstGuardThatDoesNotLetTheNodeBeTickedDecides) {
  Compile("<Sleep msec='5' _failureIf='a == 1' _successIf='b == 1' _skipIf='c == 1'/>");
  const auto values = [&](double a, double b, double c) {
    return Values({{"a", a}, {"b", b}, {"c", c}});
  };
  EXPECT_EQ(Decision(false, values(1, 1, 1)), Status::kFailure);
  EXPECT_EQ(Decision(false, values(0, 1, 1)), Status::kSuccess);
  EXPECT_EQ(Decision(false, values(0, 0, 1)), Status::kSkipped);
  EXPECT_EQ(Decision(false, values(0, 0, 0)), std::nullopt);
  EXPECT_EQ(Decision(true, values(1, 1, 1)), std::nullopt) << "a node that runs is not asked";
  EXPECT_EQ(Decision(false, Values({{"b", 1}})), std::nullopt) << "the first one threw";
}

TEST_F(ReadingsTest, WhileIsAskedOfANodeThatRunsToo) {
  Compile("<Sleep msec='5' _while='go == 1'/>");
  EXPECT_EQ(Decision(true, Values({{"go", 0}})), Status::kSkipped);
  EXPECT_EQ(Decision(false, Values({{"go", 0}})), Status::kSkipped);
  EXPECT_EQ(Decision(true, Values({{"go", 1}})), std::nullopt);
}

TEST_F(ReadingsTest, AStepReadsWhatWasWrittenBeforeItAndNotWhatItWroteItself) {
  Compile(
      "<Sequence><Script name='one' code='n := 1'/><ScriptCondition name='see' code='n == 1'/>"
      "<Script name='two' code='n := n + 1'/></Sequence>");
  run_->Tick();
  const TickView view = run_->keeper.run.Before(0);
  const Walk walk = WalkOf(tree_.shape, view.events.words, &view.statuses);
  const auto n_at = [&](std::uint32_t node) {
    const SlotValues values = ValuesAt(view, walk, tree_.shape, walk.LastStepOf(NodeIndex(node)));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (tree_.description->slots[i].name == "n") return PrintValueBytes(values[i]);
    }
    return std::string("no such key");
  };
  EXPECT_EQ(n_at(1), "");
  EXPECT_EQ(n_at(2), "1");
  EXPECT_EQ(n_at(3), "1") << "before it wrote 2";
  EXPECT_EQ(n_at(0), "") << "before anything below it wrote";
}

TEST_F(ReadingsTest, WithoutAProgramNothingIsKnown) {
  Compile("<Lamp lux='{light}' _skipIf='a == 1'/>");
  tree_.program.reset();
  EXPECT_TRUE(PortReadings(tree_, kRootNode).empty());
  EXPECT_TRUE(ScriptsOf(tree_, kRootNode).empty());
  EXPECT_FALSE(DecideGuards(tree_, kRootNode, false, {}));
}

}  // namespace
}  // namespace coppice
