#include "bt_core/testing/scenario.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

constexpr char kTree[] = R"(
<root BTCPP_format="4" main_tree_to_execute="Main">
 <BehaviorTree ID="Main">
  <ReactiveFallback name="top">
   <Sequence name="try"><Leaf name="a"/><Drive name="d" goal="{g}" distance="{x}" total="{t}"/>
   </Sequence>
   <SubTree ID="In" name="in" n="{t}"/>
  </ReactiveFallback>
 </BehaviorTree>
 <BehaviorTree ID="In">
  <Timeout name="limit" msec="100"><Drive name="e" goal="{h}" total="{n}"/></Timeout>
 </BehaviorTree>
</root>)";

class ScenarioTest : public testing::Test {
 protected:
  ScenarioTest() {
    auto registry = std::make_shared<Registry>(*TestRegistry());
    registry->SetFallback(
        [this](const std::string& name) { return std::make_unique<ScriptedLeaf>(unknown_, name); });
    Diagnostics diagnostics;
    program_ = CompileText(kTree, diagnostics, registry);
    if (!program_) throw std::logic_error(diagnostics.ToString());
    scenario_.leaves = {Rule("a", {Status::kFailure}), Rule("e", {Status::kRunning})};
  }

  static PlacedRule Rule(const std::string& pattern, std::vector<Status> results) {
    PlacedRule placed;
    placed.rule.pattern = pattern;
    placed.rule.script.results = std::move(results);
    return placed;
  }
  static ExpectedEvent Event(bool halted, const std::string& leaf,
                             std::optional<Status> status = {}) {
    return {{}, halted, leaf, status, {}};
  }

  ScenarioStep& NewStep() { return scenario_.steps.emplace_back(); }
  std::string Play() {
    result_ = RunScenario(*program_, suite_, scenario_);
    std::string text;
    for (const Difference& difference : result_.differences) {
      text += std::to_string(difference.step) + " " + difference.what + ": expected " +
              difference.expected + ", got " + difference.got + "\n";
    }
    return text;
  }

  LeafScript unknown_;
  std::shared_ptr<const Program> program_;
  ScenarioSuite suite_;
  Scenario scenario_;
  ScenarioResult result_;
};

TEST_F(ScenarioTest, PassesWhenAllIsAsExpected) {
  Expectations& first = NewStep().expect;
  first.status = ExpectedStatus{{}, "", Status::kRunning};
  first.nodes = {
      {{}, "top", Status::kRunning}, {{}, "in/e", Status::kRunning}, {{}, "try", Status::kFailure}};
  first.events = ExpectedEvents{
      {}, {Event(false, "a", Status::kFailure), Event(false, "in/e", Status::kRunning)}};
  first.blackboard = {{{{}, "x", ""}, true}};
  NewStep().halt = true;
  scenario_.steps[1].expect.events = ExpectedEvents{{}, {Event(true, "e")}};
  EXPECT_EQ(Play(), "");
  EXPECT_EQ(result_.ticks, 1U);
}

TEST_F(ScenarioTest, TellsStatusesThatDiffer) {
  Expectations& expect = NewStep().expect;
  expect.status = ExpectedStatus{{"s.json", 7, 9}, "", Status::kSuccess};
  expect.nodes = {{{}, "in/e", Status::kIdle}, {{}, "in/f", Status::kIdle}};
  EXPECT_EQ(Play(),
            "1 status of the tree: expected SUCCESS, got RUNNING\n"
            "1 status of node \"in/e\": expected IDLE, got RUNNING\n"
            "1 node \"in/f\": expected a node of the tree, got none, did you mean \"in/e\"?\n");
  EXPECT_EQ(result_.differences[0].where.line, 7U);
}

TEST_F(ScenarioTest, TellsTheFirstEventThatDiffers) {
  for (int i = 0; i < 4; ++i) NewStep().expect.events.emplace();
  auto events = [this](int step) -> auto& { return scenario_.steps[step].expect.events->events; };
  events(0) = {Event(false, "a"), Event(false, "e", Status::kSuccess)};
  events(1) = {Event(false, "a"), Event(true, "e")};
  events(2) = {Event(false, "a")};
  events(3) = {Event(false, "a"), Event(false, "/e"), Event(false, "e")};
  EXPECT_EQ(Play(),
            "1 event 2: expected tick e SUCCESS, got tick e RUNNING\n"
            "2 event 2: expected halt e, got tick e RUNNING\n"
            "3 event 2: expected no more events, got tick e RUNNING\n"
            "4 event 2: expected tick /e, got tick e RUNNING\n");
}

TEST_F(ScenarioTest, InputsOfALeafCanBeExpected) {
  scenario_.leaves.push_back(Rule("d", {Status::kSuccess}));
  ScenarioStep& step = NewStep();
  step.leaves = {Rule("a", {Status::kSuccess})};
  step.set = {{{}, "g", "2.50", KeyValue::Kind::kNumber}};
  step.expect.events.emplace();
  step.expect.events->events = {Event(false, "a"), Event(false, "d")};
  step.expect.events->events[1].inputs = {{{}, "goal", "2.5"}};
  EXPECT_EQ(Play(), "");
  scenario_.steps[0].expect.events->events[1].inputs = {{{}, "goal", "3"}};
  EXPECT_EQ(Play(),
            "1 event 2: expected tick d goal=\"3\", got tick d SUCCESS goal=\"2.5\" tries=\"3\"\n");
}

TEST_F(ScenarioTest, ValuesReachRealLeavesAndComeBack) {
  ScenarioStep& step = NewStep();
  step.leaves = {Rule("a", {Status::kSuccess})};
  step.set = {{{}, "g", "4", KeyValue::Kind::kNumber}, {{}, "t", "10", KeyValue::Kind::kNumber}};
  step.expect.status = ExpectedStatus{{}, "", Status::kSuccess};
  step.expect.blackboard = {{{{}, "x", "8.0"}, false}, {{{}, "t", "13"}, false}};
  EXPECT_EQ(Play(), "");
  scenario_.steps[0].expect.blackboard = {
      {{{}, "x", "7"}, false}, {{{}, "t", ""}, true}, {{{}, "in/h", "1"}, false}};
  EXPECT_EQ(Play(),
            "1 key \"x\": expected 7, got 8\n"
            "1 key \"t\": expected not written, got 13\n"
            "1 key \"in/h\": expected 1, got not written\n");
}

TEST_F(ScenarioTest, KeysAndTypesThatAreNoneAreTold) {
  NewStep().set = {{{}, "y", "5"}, {{}, "g", "far"}, {{}, "in/k", "1"}};
  EXPECT_EQ(Play(),
            "1 key \"y\": expected a key of the tree, got none, did you mean \"g\"?\n"
            "1 key \"g\": expected a value of type double, got far\n"
            "1 key \"in/k\": expected a key of the tree, got none, did you mean \"in/h\"?\n");
}

TEST_F(ScenarioTest, TimePassesBeforeTheTick) {
  NewStep();
  NewStep().advance = std::chrono::milliseconds(99);
  NewStep().advance = std::chrono::milliseconds(1);
  scenario_.steps[1].expect.status = ExpectedStatus{{}, "", Status::kRunning};
  scenario_.steps[2].expect.status = ExpectedStatus{{}, "", Status::kFailure};
  EXPECT_EQ(Play(), "");
}

TEST_F(ScenarioTest, AStepMayTickSeveralTimesOrNotAtAll) {
  NewStep().ticks = 3;
  scenario_.steps[0].expect.events.emplace();
  NewStep().ticks = 0;
  EXPECT_NE(Play(), "");
  EXPECT_EQ(result_.ticks, 3U);
}

TEST_F(ScenarioTest, MessagesAreLookedThrough) {
  scenario_.leaves[0].rule.script.says = "the door is closed";
  NewStep().expect.messages = {{{}, "door"}, {{}, "window"}};
  EXPECT_EQ(Play(), "1 messages: expected one with \"window\", got a: the door is closed\n");
}

TEST_F(ScenarioTest, TheRulesOfAScenarioComeBeforeThoseOfItsFile) {
  suite_.leaves = {Rule("a", {Status::kSuccess}), Rule("<Drive>", {Status::kSuccess})};
  NewStep().expect.events.emplace();
  scenario_.steps[0].expect.events->events = {Event(false, "a", Status::kFailure),
                                              Event(false, "e", Status::kRunning)};
  EXPECT_EQ(Play(), "");
}

TEST_F(ScenarioTest, ARuleThatFitsNothingIsTold) {
  scenario_.leaves.push_back(Rule("<Dirve>", {}));
  NewStep().leaves = {Rule("d", {})};
  EXPECT_EQ(Play(), "0 leaves: expected a node of the tree that fits \"<Dirve>\", got none\n");
  scenario_.leaves.pop_back();
  EXPECT_EQ(Play(),
            "1 leaves: expected a node with a script from the start that fits \"d\", got none\n");
}

TEST_F(ScenarioTest, ALeafThatNobodyKnowsNeedsARule) {
  scenario_.leaves.erase(scenario_.leaves.begin());
  NewStep();
  EXPECT_EQ(Play(),
            "0 leaves: expected a rule for \"a\", whose type <Leaf> is not known here, got none\n");
  EXPECT_EQ(result_.ticks, 0U);
}

}  // namespace
}  // namespace coppice
