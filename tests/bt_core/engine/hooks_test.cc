#include <gtest/gtest.h>

#include "bt_core/engine/node_hooks.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;
using Names = std::vector<std::string>;

class Hooks : public NodeHooks {
 public:
  void BeforeTick() override { ++ticks; }
  std::optional<Status> Before(NodeIndex node) override {
    calls.push_back("before " + std::to_string(node));
    return before;
  }
  std::optional<Status> After(NodeIndex node, Status result) override {
    calls.push_back("after " + std::to_string(node) + " " + ToString(result));
    return after;
  }
  std::optional<Status> before;
  std::optional<Status> after;
  Names calls;
  int ticks = 0;
};

LeafScript Results(std::map<std::string, std::vector<Status>> results) {
  LeafScript script;
  script.results = std::move(results);
  return script;
}

TEST(NodeHooks, AreAskedBeforeAndAfterAChosenNodeOnly) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"));
  Hooks hooks;
  stage.executor->SetHooks(&hooks, {NodeIndex{2}});
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(hooks.calls, (Names{"before 2", "after 2 SUCCESS"}));
  EXPECT_EQ(hooks.ticks, 1);
}

TEST(NodeHooks, AResultBeforeTakesThePlaceOfTheTick) {
  Stage stage(Main(R"(<Fallback><Leaf name="a"/><Leaf name="b"/></Fallback>)"));
  Hooks hooks;
  hooks.before = kFailure;
  stage.executor->SetHooks(&hooks, {NodeIndex{1}});
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.TakeEvents(), Names{"start b"});
}

TEST(NodeHooks, AResultBeforeHaltsWhatRan) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning}}}));
  stage.executor->Tick();
  Hooks hooks;
  hooks.before = kSuccess;
  stage.executor->SetHooks(&hooks, {kRootNode});
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a", "halt a"}));
}

TEST(NodeHooks, AResultAfterTakesThePlaceOfTheNodesOwn) {
  Stage stage(Main(R"(<Inverter><Leaf name="a"/></Inverter>)"), Results({{"a", {kRunning}}}));
  Hooks hooks;
  hooks.after = kFailure;
  stage.executor->SetHooks(&hooks, {NodeIndex{1}});
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a", "halt a"}));
}

TEST(NodeHooks, AGuardThatDecidesIsBeforeTheHook) {
  Stage stage(Main(R"(<Leaf name="a" _failureIf="true"/>)"));
  Hooks hooks;
  hooks.before = kSuccess;
  stage.executor->SetHooks(&hooks, {kRootNode});
  EXPECT_EQ(stage.executor->Tick(), kFailure);
  EXPECT_EQ(hooks.calls, Names());
}

TEST(NodeHooks, AHookedNodeKeepsItsGuardsAndHooks) {
  Stage stage(Main(R"(<Leaf name="a" _onHalted="halted:=1"/>)"), Results({{"a", {kRunning}}}));
  Hooks hooks;
  stage.executor->SetHooks(&hooks, {kRootNode});
  stage.executor->Tick();
  stage.executor->Halt();
  const SlotIndex halted = stage.program->layout.Find(kMainScope, "halted");
  EXPECT_TRUE(stage.executor->blackboard()[halted].value.has_value());
}

TEST(NodeHooks, TakenAwayAreNotAsked) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  Hooks hooks;
  stage.executor->SetHooks(&hooks, {kRootNode});
  stage.executor->SetHooks(nullptr);
  stage.executor->Tick();
  EXPECT_EQ(hooks.calls, Names());
  EXPECT_EQ(hooks.ticks, 0);
}

TEST(NodeHooks, AnInjectedResultIsReportedBeforeIt) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  struct Watch : TickSink {
    void OnTick(const TickEvents& events) override {
      EventReader reader(events.words);
      for (Event event; reader.Next(event);) codes.push_back(event.code);
    }
    std::vector<EventCode> codes;
  } watch;
  Hooks hooks;
  hooks.before = kFailure;
  stage.executor->SetHooks(&hooks, {kRootNode});
  stage.executor->AddSink(&watch);
  stage.executor->Tick();
  stage.executor->RemoveSink(&watch);
  EXPECT_EQ(watch.codes, (std::vector<EventCode>{EventCode::kText, EventCode::kFailure}));
}

TEST(NodeHooks, WatchersCanSeeHowFarATickCame) {
  struct Stop : Hooks {
    std::optional<Status> Before(NodeIndex) override {
      executor->ReportSoFar();
      return std::nullopt;
    }
    Executor* executor = nullptr;
  } hooks;
  struct Watch : TickSink {
    void OnTick(const TickEvents& events) override {
      parts.emplace_back(events.is_whole, events.words.size);
    }
    std::vector<std::pair<bool, std::size_t>> parts;
  } watch;
  Stage stage(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"));
  hooks.executor = stage.executor.get();
  stage.executor->SetHooks(&hooks, {NodeIndex{2}});
  stage.executor->AddSink(&watch);
  stage.executor->Tick();
  stage.executor->RemoveSink(&watch);
  EXPECT_EQ(watch.parts, (std::vector<std::pair<bool, std::size_t>>{{false, 1}, {true, 2}}));
}

TEST(NodeHooks, ANodeThatAHookMadeRunningBeginsWhenItIsTicked) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/></Sequence>)"), Results({{"a", {kRunning}}}));
  Hooks hooks;
  hooks.before = kRunning;
  stage.executor->SetHooks(&hooks, {NodeIndex{1}});
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  hooks.before.reset();
  stage.executor->Tick();
  stage.executor->Tick();
  stage.executor->Halt();
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a", "tick a", "halt a"}));
}

TEST(NodeHooks, ANodeThatAHookMadeRunningIsNotToldOfAHalt) {
  Stage stage(Main(R"(<Sequence><Inverter><Leaf name="a"/></Inverter></Sequence>)"));
  Hooks hooks;
  hooks.before = kRunning;
  stage.executor->SetHooks(&hooks, {NodeIndex{2}});
  for (const bool by_root : {true, false}) {
    EXPECT_EQ(stage.executor->Tick(), kRunning);
    by_root ? stage.executor->Halt() : stage.executor->Halt(NodeIndex{2});
    EXPECT_EQ(stage.TakeEvents(), Names());
  }
}

TEST(NodeHooks, ANodeThatAHookMadeRunningBeginsWhenTheHooksAreTakenAway) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning}}}));
  Hooks hooks;
  hooks.before = kRunning;
  stage.executor->SetHooks(&hooks, {kRootNode});
  stage.executor->Tick();
  stage.executor->SetHooks(nullptr);
  stage.executor->Tick();
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a"}));
}

TEST(NodeHooks, AreToldThatTheTreeWasSwapped) {
  struct Reloaded : Hooks {
    void OnReload() override { ++reloads; }
    int reloads = 0;
  } hooks;
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  const Stage other(Main(R"(<Leaf name="b"/>)"));
  stage.executor->SetHooks(&hooks, {kRootNode});
  stage.executor->Reload(other.program);
  EXPECT_EQ(hooks.reloads, 1);
  stage.executor->Tick();
  EXPECT_EQ(hooks.calls, Names());
  stage.executor.reset();
}

}  // namespace
}  // namespace coppice
