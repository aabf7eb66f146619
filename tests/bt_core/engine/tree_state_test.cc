#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using Names = std::vector<std::string>;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSkipped = Status::kSkipped;
constexpr Status kSuccess = Status::kSuccess;

// Is SKIPPED when it has run; never stops by itself.
class Slow : public Action {
 public:
  static constexpr const char* kDescription = "Stops when it is given up.";
  explicit Slow(Names* events) : events_(*events) {}
  Status OnStart() override {
    events_.emplace_back("start");
    return kRunning;
  }
  Status OnRunning() override { return kSkipped; }
  void OnHalted() override {
    events_.emplace_back("halt");
    DrainFor(std::chrono::seconds(2));
  }
  bool OnDraining() override { return false; }

 private:
  Names& events_;
};

LeafScript Results(std::map<std::string, std::vector<Status>> results) {
  LeafScript script;
  script.results = std::move(results);
  return script;
}

TEST(TreeState, BringsBackStatusesAndMemory) {
  Stage stage(Main(R"(<Repeat num_cycles="3"><Sequence><AlwaysSuccess/><Leaf name="a"/>)"
                   "</Sequence></Repeat>"),
              Results({{"a", {kRunning, kSuccess, kRunning, kRunning}}}));
  stage.executor->Tick();
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  EXPECT_NE(stage.executor->Save().memory, state.memory);
  stage.executor->Restore(state);
  EXPECT_EQ(stage.executor->Save().memory, state.memory);
}

TEST(TreeState, BringsBackTheBlackboard) {
  Stage stage(Main(R"(<Drive goal="2" total="{total}" distance="{way}"/>)"));
  stage.executor->Tick();
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  stage.executor->Restore(state);
  stage.executor->Tick();
  const SlotIndex total = stage.program->layout.Find(kMainScope, "total");
  EXPECT_EQ(stage.executor->blackboard()[total].value.Get<int>(), 6);
}

TEST(TreeState, HaltsWhatDidNotRunThen) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning}}}));
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor->Restore(state);
  EXPECT_EQ(stage.TakeEvents(), (Names{"halt a"}));
}

TEST(TreeState, StartsWhatRanThenInTheNextTick) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"),
              Results({{"a", {kSuccess}}, {"b", {kRunning, kSuccess, kRunning}}}));
  stage.executor->Tick();
  const TreeState state = stage.executor->Save();
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  stage.TakeEvents();
  stage.executor->Restore(state);
  EXPECT_EQ(stage.executor->statuses()[0], kRunning);
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.TakeEvents(), (Names{"start b"}));
}

// A leaf that is RUNNING and then SKIPPED keeps what it has begun (docs/semantics.md).
TEST(TreeState, WhatASkippedLeafHasBegunGoesOn) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning, kSkipped, kRunning}}}));
  stage.executor->Tick();
  stage.executor->Tick();
  const TreeState skipped = stage.executor->Save();
  stage.executor->Restore(skipped);
  EXPECT_EQ(stage.executor->statuses()[0], kSkipped);
  stage.executor->Tick();
  stage.executor->Tick();
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a", "tick a", "tick a", "tick a"}));
}

TEST(TreeState, ALeafThatRunsGoesOnAsTheSkippedOneItWas) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning, kSkipped, kRunning}}}));
  stage.executor->Tick();
  stage.executor->Tick();
  const TreeState skipped = stage.executor->Save();
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor->Restore(skipped);
  EXPECT_EQ(stage.executor->statuses()[0], kSkipped);
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.TakeEvents(), (Names{"tick a"}));
  stage.executor->Restore(skipped);
  stage.executor->Halt();
  EXPECT_EQ(stage.TakeEvents(), (Names{"halt a"}));
}

TEST(TreeState, ASkippedLeafGoesOnAsTheRunningOneItWas) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning, kSkipped, kSuccess}}}));
  stage.executor->Tick();
  const TreeState running = stage.executor->Save();
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor->Restore(running);
  EXPECT_EQ(stage.executor->statuses()[0], kRunning);
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.TakeEvents(), (Names{"tick a", "start a"}));
}

TEST(TreeState, HaltsASkippedLeafThatHadNotBegunThen) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning, kSkipped, kRunning}}}));
  const TreeState fresh = stage.executor->Save();
  stage.executor->Tick();
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor->Restore(fresh);
  EXPECT_EQ(stage.TakeEvents(), (Names{"halt a"}));
  stage.executor->Tick();
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a"}));
}

TEST(TreeState, WhatIsGoneOfASkippedLeafStartsAgain) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kRunning, kSkipped, kRunning}}}));
  stage.executor->Tick();
  stage.executor->Tick();
  const TreeState skipped = stage.executor->Save();
  stage.executor->Halt();
  stage.TakeEvents();
  stage.executor->Restore(skipped);
  EXPECT_EQ(stage.executor->statuses()[0], kSkipped);
  stage.executor->Halt();
  EXPECT_EQ(stage.TakeEvents(), Names{});
  stage.executor->Restore(skipped);
  stage.executor->Tick();
  EXPECT_EQ(stage.TakeEvents(), (Names{"start a"}));
}

TEST(TreeState, BringsBackTheRoundsOfASkippedLoop) {
  Stage stage(Main(R"(<Repeat num_cycles="2"><Leaf name="a"/></Repeat>)"),
              Results({{"a", {kSuccess, kSkipped, kSuccess}}}));
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->Tick(), kSkipped);
  const TreeState one_done = stage.executor->Save();
  stage.executor->Halt();
  stage.executor->Restore(one_done);
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  stage.executor->Restore(one_done);
  stage.executor->Halt();
  EXPECT_EQ(stage.executor->Tick(), kRunning);
}

TEST(TreeState, ALeafThatWaitsUntilItHasStoppedHasBegunNothing) {
  Names events;
  SimulatedClock clock;
  auto registry = std::make_shared<Registry>();
  registry->Register<Slow>("Slow", &events);
  Diagnostics diagnostics;
  Executor executor(CompileText(Main("<Slow/>"), diagnostics, registry), clock);
  executor.Tick();
  executor.Tick();
  const TreeState skipped = executor.Save();
  executor.Halt();
  EXPECT_EQ(executor.Tick(), kRunning);
  executor.Restore(skipped);
  clock.Advance(std::chrono::seconds(2));
  events.clear();
  EXPECT_EQ(executor.Tick(), kRunning);
  EXPECT_EQ(events, (Names{"start"}));
}

TEST(TreeState, AsksForATickIfTheTreeRan) {
  Stage stage(Main(R"(<Sleep msec="50"/>)"));
  stage.executor->Tick();
  const TreeState state = stage.executor->Save();
  stage.clock.Advance(std::chrono::milliseconds(50));
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.executor->next_tick(), kNever);
  stage.executor->Restore(state);
  EXPECT_EQ(stage.executor->next_tick(), Time{});
}

TEST(TreeState, SinksAreToldOfARestore) {
  struct Watch : TickSink {
    void OnTick(const TickEvents&) override {}
    void OnJump(const Executor& executor) override { statuses = executor.statuses(); }
    std::vector<Status> statuses;
  } watch;
  Stage stage(Main(R"(<Leaf name="a"/>)"), Results({{"a", {kSuccess}}}));
  const TreeState state = stage.executor->Save();
  stage.executor->Tick();
  stage.executor->AddSink(&watch);
  stage.executor->Restore(state);
  stage.executor->RemoveSink(&watch);
  EXPECT_EQ(watch.statuses, std::vector<Status>{Status::kIdle});
}

TEST(TreeState, OfAnotherTreeIsRefused) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  Stage other(Main(R"(<Inverter><Leaf name="a"/></Inverter>)"));
  EXPECT_THROW(stage.executor->Restore(other.executor->Save()), std::invalid_argument);
}

}  // namespace
}  // namespace coppice
