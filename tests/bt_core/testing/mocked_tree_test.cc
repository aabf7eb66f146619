#include "bt_core/testing/mocked_tree.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;
using Results = std::vector<Status>;

MockScript Returns(Results results) {
  MockScript script;
  script.results = std::move(results);
  return script;
}

class MockedTreeTest : public testing::Test {
 protected:
  MockedTree& Make(const std::string& body, std::vector<MockRule> rules) {
    tree_ = std::make_unique<MockedTree>(*CompiledText(body), std::move(rules), clock_,
                                         MockOptions{true});
    return *tree_;
  }
  std::shared_ptr<const Program> CompiledText(const std::string& text) {
    auto registry = std::make_shared<Registry>(*TestRegistry());
    registry->SetFallback(
        [this](const std::string& name) { return std::make_unique<ScriptedLeaf>(real_, name); });
    Diagnostics diagnostics;
    auto program = CompileText(text, diagnostics, registry);
    if (!program) throw std::logic_error(diagnostics.ToString());
    return program;
  }
  std::shared_ptr<const Program> Compiled(const std::string& root) {
    return CompiledText(Main(root));
  }

  std::string Tick() {
    const std::string status = ToString(tree_->executor().Tick());
    return status + ":" + Events();
  }
  std::string Events() {
    std::string text;
    for (const LeafEvent& event : tree_->TakeEvents()) {
      text += event.halted ? " halt " : " tick ";
      text += tree_->program().Name(event.node);
      if (!event.halted) text += std::string(" ") + ToString(event.result);
      for (const auto& [port, value] : event.inputs) text += " " + port + "=" + value;
      text += ",";
    }
    return text;
  }

  LeafScript real_;
  SimulatedClock clock_{std::chrono::seconds(1)};
  std::unique_ptr<MockedTree> tree_;
};

TEST_F(MockedTreeTest, AScriptPlaysALeaf) {
  Make(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"),
       {{"b", Returns({Status::kRunning, Status::kSuccess})}});
  EXPECT_EQ(Tick(), "RUNNING: tick a SUCCESS, tick b RUNNING,");
  EXPECT_EQ(Tick(), "SUCCESS: tick b SUCCESS,");
  EXPECT_EQ(real_.events, std::vector<std::string>{"start a"}) << "the real b was never asked";
}

TEST_F(MockedTreeTest, TheLastResultRepeats) {
  Make(Main(R"(<Leaf name="a"/>)"), {{"a", Returns({Status::kFailure, Status::kSkipped})}});
  EXPECT_EQ(Tick(), "FAILURE: tick a FAILURE,");
  EXPECT_EQ(Tick(), "SKIPPED: tick a SKIPPED,");
  EXPECT_EQ(Tick(), "SKIPPED: tick a SKIPPED,");
}

TEST_F(MockedTreeTest, AScriptMayRestartWithEveryActivation) {
  MockScript script = Returns({Status::kRunning, Status::kSuccess});
  script.restart = true;
  Make(Main(R"(<Leaf name="a"/>)"), {{"a", script}});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(Tick(), "RUNNING: tick a RUNNING,");
    EXPECT_EQ(Tick(), "SUCCESS: tick a SUCCESS,");
  }
}

TEST_F(MockedTreeTest, HaltsAreWrittenDown) {
  Make(Main(R"(<ReactiveSequence><Leaf name="a"/><Leaf name="b"/></ReactiveSequence>)"),
       {{"<Leaf>", Returns({Status::kSuccess, Status::kFailure})},
        {"b", Returns({Status::kRunning})}});
  Tick();
  EXPECT_EQ(Tick(), "FAILURE: tick a FAILURE, halt b,");
}

TEST_F(MockedTreeTest, ALeafThatTakesTimeAsksForATickAtItsEnd) {
  MockScript script;
  script.duration = milliseconds(300);
  Make(Main(R"(<Leaf name="a"/>)"), {{"a", script}});
  EXPECT_EQ(Tick(), "RUNNING: tick a RUNNING,");
  EXPECT_EQ(tree_->executor().next_tick(), clock_.Now() + milliseconds(300));
  clock_.Advance(milliseconds(299));
  EXPECT_EQ(Tick(), "RUNNING: tick a RUNNING,");
  clock_.Advance(milliseconds(1));
  EXPECT_EQ(Tick(), "SUCCESS: tick a SUCCESS,");
}

TEST_F(MockedTreeTest, OutputsOfAPlayedLeafReachItsReader) {
  MockScript script;
  script.outputs = {{"distance", "2.5"}};
  Make(Main(R"(<Sequence><Drive name="d" goal="1" distance="{x}" total="{t}"/>)"
            R"(<Drive name="e" goal="{x}" total="{t}"/></Sequence>)"),
       {{"d", script}});
  EXPECT_EQ(Tick(), "SUCCESS: tick d SUCCESS goal=1 tries=3, tick e SUCCESS goal=2.5 tries=3,");
}

TEST_F(MockedTreeTest, WhatHoldsIsDrawnAgainOnlyAfterThatTime) {
  MockScript script;
  script.chances = Chances{1, 1, 0, Duration(0), Duration(0), milliseconds(500), milliseconds(500)};
  Make(Main(R"(<Leaf name="a"/>)"), {{"a", script}});
  int changes = 0;
  Status last = tree_->executor().Tick();
  for (int i = 1; i < 100; ++i) {
    clock_.Advance(milliseconds(100));
    const Status status = tree_->executor().Tick();
    if (status != last) {
      EXPECT_EQ(i % 5, 0);
      ++changes;
    }
    last = status;
  }
  EXPECT_GT(changes, 3);
}

TEST_F(MockedTreeTest, FeedbackIsWrittenWhileALeafRuns) {
  MockScript script = Returns({Status::kRunning, Status::kSuccess});
  script.feedback = {{"distance", "2.5"}};
  Make(Main(R"(<ReactiveFallback><Sequence><ScriptCondition code="x == 2.5"/>)"
            R"(<Leaf name="near"/></Sequence>)"
            R"(<Drive name="d" goal="1" distance="{x}" total="{t}"/></ReactiveFallback>)"),
       {{"d", script}, {"near", Returns({Status::kSuccess})}});
  tree_->executor().Tick();
  EXPECT_NE(Events().find("tick d RUNNING"), std::string::npos);
  tree_->executor().Tick();
  EXPECT_NE(Events().find("tick near SUCCESS"), std::string::npos);
}

TEST_F(MockedTreeTest, AnOutputThatIsNoneIsAFailureWithAMessage) {
  KeepingSink sink;
  for (const auto& [port, text] : {std::pair("distance", "far"), std::pair("speed", "1")}) {
    MockScript script;
    script.outputs = {{port, text}};
    Make(Main(R"(<Drive name="d" goal="1" distance="{x}" total="{t}"/>)"), {{"d", script}});
    tree_->executor().AddSink(&sink);
    EXPECT_EQ(tree_->executor().Tick(), Status::kFailure);
    tree_->executor().RemoveSink(&sink);
  }
  ASSERT_EQ(sink.ticks.size(), 2U);
  EXPECT_EQ(sink.ticks[0].messages[0].text,
            R"("far" is not a value for output "distance", expected double)");
  EXPECT_EQ(sink.ticks[1].messages[0].text, R"(the scripted node has no port "speed")");
}

TEST_F(MockedTreeTest, AScriptMaySpeakAndThrow) {
  KeepingSink sink;
  MockScript speaks = Returns({Status::kFailure});
  speaks.says = "no way";
  MockScript throws;
  throws.throws = "broken";
  Make(Main(R"(<Fallback><Leaf name="a"/><Leaf name="b"/></Fallback>)"),
       {{"a", speaks}, {"b", throws}});
  tree_->executor().AddSink(&sink);
  EXPECT_EQ(Tick(), "FAILURE: tick a FAILURE, tick b FAILURE,");
  ASSERT_EQ(sink.ticks.back().messages.size(), 2U);
  EXPECT_EQ(sink.ticks.back().messages[0].text, "no way");
  EXPECT_EQ(sink.ticks.back().messages[1].text, "broken");
  tree_->executor().RemoveSink(&sink);
}

TEST_F(MockedTreeTest, ControlNodesAndSubTreesCanBePlayedWithAllBelowThem) {
  Make(R"(<root BTCPP_format="4" main_tree_to_execute="Main">
 <BehaviorTree ID="Main"><Sequence>
   <Fallback name="f"><Leaf name="a"/><Leaf name="b"/></Fallback>
   <SubTree ID="In"/><Repeat name="r" num_cycles="3"><Leaf name="d"/></Repeat>
 </Sequence></BehaviorTree>
 <BehaviorTree ID="In"><Leaf name="c"/></BehaviorTree>
</root>)",
       {{"f", Returns({Status::kRunning, Status::kSuccess})},
        {"<In>", Returns({Status::kSkipped})},
        {"r", Returns({Status::kRunning})}});
  EXPECT_EQ(Tick(), "RUNNING: tick f RUNNING,");
  EXPECT_EQ(Tick(), "RUNNING: tick f SUCCESS, tick In SKIPPED, tick r RUNNING num_cycles=3,");
  tree_->executor().Halt();
  EXPECT_EQ(Events(), " halt r,");
  EXPECT_TRUE(real_.events.empty());
}

TEST_F(MockedTreeTest, RealLeavesKeepTheirPortsAndAreWatched) {
  Make(Main(R"(<Sequence><Drive name="d" goal="4" distance="{x}" total="{t}"/>)"
            R"(<Drive name="e" goal="{x}" total="{t}"/></Sequence>)"),
       {});
  EXPECT_EQ(Tick(),
            "SUCCESS: tick d SUCCESS goal=4 tries=3, tick e SUCCESS goal=8 tries=3 "
            "total=3,");
}

TEST_F(MockedTreeTest, ARealLeafThatThrowsIsWatchedToo) {
  real_.on_tick["a"] = [] { throw std::runtime_error("broken"); };
  Make(Main(R"(<Leaf name="a"/>)"), {});
  EXPECT_EQ(Tick(), "FAILURE: tick a FAILURE,");
}

TEST_F(MockedTreeTest, AScriptCanBeExchanged) {
  Make(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"),
       {{"a", Returns({Status::kRunning})}});
  EXPECT_EQ(Tick(), "RUNNING: tick a RUNNING,");
  EXPECT_EQ(tree_->ChangeScript("a", Returns({Status::kFailure})), 1);
  EXPECT_EQ(Tick(), "FAILURE: tick a FAILURE,");
  EXPECT_EQ(tree_->ChangeScript("b", MockScript()), 0) << "b plays itself";
}

TEST_F(MockedTreeTest, NamesRulesThatFitNothingAndLeavesThatNobodyKnows) {
  Make(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/><AlwaysSuccess/></Sequence>)"),
       {{"a", {}}, {"c", {}}, {"<Drive>", {}}});
  EXPECT_EQ(tree_->UnusedPatterns(), (std::vector<std::string>{"c", "<Drive>"}));
  ASSERT_EQ(tree_->UnknownLeaves().size(), 1U);
  EXPECT_EQ(tree_->program().Name(tree_->UnknownLeaves()[0]), "b");
}

TEST_F(MockedTreeTest, AnExchangedScriptEndsWhatTheOldOneHadBegun) {
  MockScript slow = Returns({Status::kSuccess});
  slow.duration = milliseconds(500);
  Make(Main(R"(<Leaf name="a"/>)"), {{"a", slow}});
  EXPECT_EQ(Tick(), "RUNNING: tick a RUNNING,");
  tree_->ChangeScript("a", Returns({Status::kFailure}));
  EXPECT_EQ(Tick(), "FAILURE: tick a FAILURE,");
  Tick();
  tree_->ChangeScript("a", slow);
  EXPECT_EQ(Tick(), "RUNNING: tick a RUNNING,");
  clock_.Advance(milliseconds(500));
  EXPECT_EQ(Tick(), "SUCCESS: tick a SUCCESS,");
}

TEST_F(MockedTreeTest, AfterAReloadWhatLivesOnGoesOnInItsScript) {
  const std::vector<MockRule> rules = {{"<Leaf>", Returns({Status::kSuccess})}};
  Make(Main(R"(<Sequence><Leaf name="a"/><Parallel><Leaf name="b"/></Parallel></Sequence>)"),
       rules);
  tree_->ChangeScript("b", Returns({Status::kRunning, Status::kRunning, Status::kFailure}));
  EXPECT_EQ(Tick(), "RUNNING: tick a SUCCESS, tick b RUNNING,");
  tree_->Reload(*Compiled(R"(<Sequence><Sequence><Leaf name="c"/><Leaf name="d"/></Sequence>)"
                          R"(<Parallel><Leaf name="b"/></Parallel></Sequence>)"),
                rules);
  EXPECT_EQ(Tick(), "RUNNING: tick b RUNNING,");
  EXPECT_EQ(Tick(), "FAILURE: tick b FAILURE,");
  tree_->Reload(*Compiled(R"(<Fallback><Leaf name="b"/><Leaf name="c"/></Fallback>)"), rules);
  EXPECT_EQ(Tick(), "RUNNING: tick b RUNNING,") << "another b begins, with the script of all b";
  EXPECT_EQ(tree_->ScriptOf(NodeIndex{1})->results.size(), 3U);
  EXPECT_EQ(tree_->ScriptOf(kRootNode), nullptr);
}

TEST_F(MockedTreeTest, AReloadHaltsWhatIsGone) {
  Make(Main(R"(<Sequence><Leaf name="a"/></Sequence>)"), {{"<Leaf>", Returns({Status::kRunning})}});
  Tick();
  tree_->Reload(*Compiled(R"(<Sequence><Leaf name="b"/></Sequence>)"),
                {{"<Leaf>", Returns({Status::kRunning})}});
  const std::vector<LeafEvent> events = tree_->TakeEvents();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_TRUE(events[0].halted);
  EXPECT_EQ(Tick(), "RUNNING: tick b RUNNING,");
}

}  // namespace
}  // namespace coppice
