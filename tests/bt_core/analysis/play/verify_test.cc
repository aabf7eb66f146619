#include "bt_core/analysis/play/verify.h"

#include <gtest/gtest.h>

#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

class Counter final : public Action {
 public:
  static constexpr const char* kDescription = "Counts its ticks.";
  InOut<int> count{this, "count", "how often"};
  Output<std::string> text{this, "text", "the same in words"};

  Status OnStart() override {
    Say("starts");
    return OnRunning();
  }
  Status OnRunning() override {
    const int next = count.has_value() ? count.Get() + 1 : 1;
    count.Set(next);
    text.Set("at " + std::to_string(next));
    if (next % 7 == 0) throw std::runtime_error("seven again");
    return next % 3 == 0 ? Status::kSuccess : Status::kRunning;
  }
  void OnHalted() override {
    Say("is halted");
    text.Set("halted");
  }
};

class SlowStopper final : public Action {
 public:
  static constexpr const char* kDescription = "Needs time to stop.";
  Status OnStart() override { return Status::kRunning; }
  Status OnRunning() override { return Status::kRunning; }
  void OnHalted() override {
    asked_ = 0;
    DrainFor(std::chrono::seconds(10));
  }
  bool OnDraining() override { return ++asked_ > 2; }

 private:
  int asked_ = 0;
};

class Alternate final : public UserControl {
 public:
  static constexpr const char* kDescription = "Ticks one child after another, and halts it.";
  Input<bool> halts{this, "halts", "halt the child that was ticked last", false};
  Output<int> chosen{this, "chosen", "the child"};

  Status Tick(Children& children, bool) override {
    if (*halts) children.Halt(current_);
    current_ = (current_ + 1) % children.size();
    chosen.Set(static_cast<int>(current_));
    const Status status = children.Tick(current_);
    Say("ticked " + std::to_string(current_));
    return status == Status::kFailure ? children.Tick((current_ + 1) % children.size()) : status;
  }
  void OnHalted() override { Say("alternate is halted"); }

 private:
  std::uint32_t current_ = 0;
};

std::shared_ptr<Registry> TestNodes() {
  auto registry = std::make_shared<Registry>();
  registry->Register<Counter>("Counter");
  registry->Register<SlowStopper>("SlowStopper");
  registry->Register<Alternate>("Alternate");
  return registry;
}

Verification VerifyRun(const Recording& run) {
  Diagnostics diagnostics;
  const Verification verification = Verify(run, {}, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  return verification;
}

void ExpectTheSame(const RecordedRun& run, std::uint64_t ticks) {
  const Verification verification = VerifyRun(run.keeper.run);
  EXPECT_TRUE(verification.is_the_same())
      << PrintVerification(verification, run.keeper.run.start());
  EXPECT_EQ(verification.ticks, ticks);
  EXPECT_EQ(verification.skipped_ticks, 0u);
}

TEST(Verify, PlaysResultsWritesMessagesAndExceptionsOfLeaves) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><ReactiveFallback>"
      "<ScriptCondition code='count == 5'/>"
      "<Counter count='{count}' text='{text}' _onHalted='halts += 1' _post='posts += 1'"
      " _onStart='starts += 1'/></ReactiveFallback></BehaviorTree>",
      TestNodes());
  for (int i = 0; i < 30; ++i) run.Tick();
  run.executor.Halt();
  ExpectTheSame(run, 31);
}

TEST(Verify, PlaysTheInbox) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence><ScriptCondition code='battery > 20'/>"
      "<Counter count='{count}'/></Sequence></BehaviorTree>",
      TestNodes());
  const Sender<double> battery = run.executor.Writer<double>("battery");
  for (int i = 0; i < 30; ++i) {
    if (i % 4 == 1) battery.Send(i * 1.5);
    run.Tick();
  }
  ExpectTheSame(run, 30);
}

TEST(Verify, PlaysNodesOfTheUserThatHaveChildren) {
  for (const char* halts : {"true", "false"}) {
    RecordedRun run(
        std::string("<BehaviorTree ID='Main'><Repeat num_cycles='-1'><Alternate halts='") + halts +
            "' chosen='{chosen}'><Counter count='{a}' text='{at}'/>"
            "<Sequence><ScriptCondition code='chosen == 1'/><Counter count='{b}'/>"
            "</Sequence><AlwaysFailure/><Sleep msec='250'/></Alternate></Repeat>"
            "</BehaviorTree>",
        TestNodes());
    for (int i = 0; i < 50; ++i) {
      run.Tick();
      if (i % 17 == 5) run.executor.Halt();
    }
    ExpectTheSame(run, 53);
  }
}

TEST(Verify, PlaysNodesThatNeedTimeToStop) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><ReactiveFallback><ScriptCondition code='go == 0'/>"
      "<Timeout msec='900'><SlowStopper/></Timeout></ReactiveFallback></BehaviorTree>",
      TestNodes());
  const Sender<int> go = run.executor.Writer<int>("go");
  for (int i = 0; i < 60; ++i) {
    if (i % 5 == 0) go.Send(i % 10 == 0 ? 1 : 0);
    if (i % 5 == 1) go.Send(1);
    run.Tick();
  }
  ExpectTheSame(run, 60);
}

TEST(Verify, PlaysTimers) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Repeat num_cycles='-1'><Fallback><Timeout msec='350'><Sequence>"
      "<Delay delay_msec='120'><AlwaysSuccess/></Delay><Sleep msec='300'/></Sequence></Timeout>"
      "<RateController hz='3'><AlwaysSuccess/></RateController></Fallback></Repeat>"
      "</BehaviorTree>");
  for (int i = 0; i < 100; ++i) run.Tick(std::chrono::milliseconds(10 + 37 * i % 150));
  ExpectTheSame(run, 100);
}

TEST(Verify, PlaysASwapOfTheTree) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence><Counter name='c' count='{count}'/>"
      "<Repeat num_cycles='5'><Counter count='{n}'/></Repeat></Sequence></BehaviorTree>",
      TestNodes());
  for (int i = 0; i < 4; ++i) run.Tick();
  run.executor.Reload(CompileText(
      "<BehaviorTree ID='Main'><Sequence><Counter name='c' count='{count}'/><AlwaysSuccess/>"
      "<Repeat num_cycles='5'><Counter count='{n}'/></Repeat></Sequence></BehaviorTree>",
      TestNodes()));
  for (int i = 0; i < 20; ++i) run.Tick();
  const Verification verification = VerifyRun(run.keeper.run);
  EXPECT_TRUE(verification.is_the_same())
      << PrintVerification(verification, run.keeper.run.start());
  EXPECT_EQ(verification.skipped_ticks, 0u);
}

TEST(Verify, GoesOnBehindAGapWhereNothingRuns) {
  RecordedRun run("<BehaviorTree ID='Main'><Counter count='{count}'/></BehaviorTree>", TestNodes());
  for (int i = 0; i < 4; ++i) run.Tick();
  run.keeper.Lose();  // after tick 4 it runs
  for (int i = 0; i < 10; ++i) run.Tick();
  const Verification verification = VerifyRun(run.keeper.run);
  EXPECT_TRUE(verification.is_the_same())
      << PrintVerification(verification, run.keeper.run.start());
  EXPECT_EQ(verification.ticks, 12u);
  EXPECT_EQ(verification.skipped_ticks, 2u);
  EXPECT_EQ(verification.remarks.size(), 2u);
}

class Injector final : public NodeHooks {
 public:
  std::optional<Status> Before(NodeIndex) override { return before; }
  std::optional<Status> After(NodeIndex, Status) override { return after; }
  std::optional<Status> before;
  std::optional<Status> after;
};

TEST(Verify, PlaysInjectedResults) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Repeat num_cycles='-1'><Fallback name='f'>"
      "<Sequence><Counter name='c' count='{count}'/><AlwaysFailure/></Sequence><Sleep msec='150'/>"
      "</Fallback></Repeat></BehaviorTree>",
      TestNodes());
  Injector hooks;
  for (int i = 0; i < 80; ++i) {
    const Status status = static_cast<Status>(1 + i % 4);
    hooks.before = i % 5 == 0 ? std::optional(status) : std::nullopt;
    hooks.after = i % 7 == 0 ? std::optional(status) : std::nullopt;
    if (i % 9 == 0) run.executor.SetHooks(&hooks, {NodeIndex{3}});
    if (i % 9 == 4) run.executor.SetHooks(&hooks, {NodeIndex{1}, NodeIndex{3}, NodeIndex{5}});
    if (i % 9 == 8) run.executor.SetHooks(nullptr, {});
    run.Tick();
  }
  ExpectTheSame(run, 80);
}

TEST(Verify, PlaysTicksThatAnExceptionHasEnded) {
  SimulatedClock clock{std::chrono::seconds(1)};
  Executor executor(CompileText("<BehaviorTree ID='Main'><Parallel><Sleep msec='1000'/>"
                                "<Counter count='{count}'/></Parallel></BehaviorTree>",
                                TestNodes()),
                    clock, {ExceptionPolicy::kHaltTree});
  Keeper keeper(executor);
  for (int i = 0; i < 30; ++i) {
    executor.Tick();
    clock.Advance(std::chrono::milliseconds(50));
  }
  const Verification verification = VerifyRun(keeper.run);
  EXPECT_TRUE(verification.is_the_same()) << PrintVerification(verification, keeper.run.start());
}

// A record whose words were changed.
Recording Forged(const Recording& run, std::size_t tick, const EventWriter& words) {
  Recording forged;
  forged.OnTree(run.trees()[0]);
  forged.OnState(run.sections()[0].state);
  for (std::size_t i = 0; i < run.ticks().size(); ++i) {
    TickEvents events = run.EventsOf(i);
    if (i == tick) events.words = words.words();
    forged.OnTick(events);
  }
  return forged;
}

TEST(Verify, NamesTheFirstDivergence) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence name='s'><AlwaysSuccess name='a'/>"
      "<AlwaysFailure name='b'/></Sequence></BehaviorTree>");
  for (int i = 0; i < 5; ++i) run.Tick();
  EventWriter words;
  words.Status(NodeIndex{1}, Status::kSuccess);
  words.Status(NodeIndex{2}, Status::kSuccess);
  words.Status(kRootNode, Status::kSuccess);
  const Verification verification = VerifyRun(Forged(run.keeper.run, 2, words));
  ASSERT_TRUE(verification.divergence);
  EXPECT_EQ(verification.ticks, 2u);
  EXPECT_EQ(verification.divergence->tick, 3u);
  EXPECT_EQ(verification.divergence->node, "b");
  EXPECT_EQ(verification.divergence->expected, "b returns SUCCESS");
  EXPECT_EQ(verification.divergence->actual, "b returns FAILURE");
}

TEST(Verify, SeesThatSomethingIsMissingAtTheEndOfATick) {
  RecordedRun run("<BehaviorTree ID='Main'><Script code='x := 1'/></BehaviorTree>");
  for (int i = 0; i < 3; ++i) run.Tick();
  EventWriter words;
  words.Status(kRootNode, Status::kSuccess);
  const Verification verification = VerifyRun(Forged(run.keeper.run, 1, words));
  ASSERT_TRUE(verification.divergence);
  EXPECT_EQ(verification.divergence->tick, 2u);
  EXPECT_EQ(verification.divergence->actual, "write of {x} = 1");
}

}  // namespace
}  // namespace coppice
