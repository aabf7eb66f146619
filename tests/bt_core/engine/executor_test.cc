#include "bt_core/engine/executor.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Events = std::vector<std::string>;

constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;

LeafScript WithResults(std::map<std::string, std::vector<Status>> results) {
  LeafScript script;
  script.results = std::move(results);
  return script;
}

TEST(Executor, StatusesAreVisibleAfterATick) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/><Leaf name="c"/></Sequence>)"),
              WithResults({{"b", {kRunning}}}));
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->statuses(),
            (std::vector<Status>{kRunning, kSuccess, kRunning, Status::kIdle}));
}

TEST(Executor, TheStatusOfOneNodeIsThatAmongAll) {
  Stage stage(Main(R"(<Sequence><Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"
                   R"(<Fallback><Leaf name="c"/><Leaf name="d"/></Fallback></Sequence>)"),
              WithResults({{"c", {kRunning}}}));
  for (int ticks = 0; ticks < 2; ++ticks) {
    const std::vector<Status> all = stage.executor->statuses();
    for (NodeIndex node{0}; node < all.size(); ++node) {
      EXPECT_EQ(stage.executor->StatusOf(node), all[node]) << node;
    }
    stage.executor->Tick();
  }
}

TEST(Executor, SkippedIsVisibleToo) {
  Stage stage(Main(R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)"),
              WithResults({{"a", {Status::kSkipped}}, {"b", {kRunning}}}));
  stage.executor->Tick();
  EXPECT_EQ(stage.executor->statuses()[1], Status::kSkipped);
}

TEST(Executor, HaltsRunningLeavesInDocumentOrder) {
  Stage stage(Main(R"(<Parallel><Leaf name="a"/><Sequence><Leaf name="b"/></Sequence>)"
                   R"(<Leaf name="c"/></Parallel>)"),
              WithResults({{"a", {kRunning}}, {"b", {kRunning}}}));
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor->Halt();
  EXPECT_EQ(stage.TakeEvents(), (Events{"halt a", "halt b"}));
  for (const Status status : stage.executor->statuses()) EXPECT_EQ(status, Status::kIdle);
}

TEST(Executor, HaltsWhatRunsWhenItIsDestroyed) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), WithResults({{"a", {kRunning}}}));
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor.reset();
  EXPECT_EQ(stage.TakeEvents(), Events{"halt a"});
}

TEST(Executor, StartsAgainAfterAHalt) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), WithResults({{"a", {kRunning}}}));
  stage.executor->Tick();
  stage.executor->Tick();
  stage.executor->Halt();
  stage.executor->Tick();
  EXPECT_EQ(stage.TakeEvents(), (Events{"start a", "tick a", "halt a", "start a"}));
}

TEST(Executor, AppliesTheInboxAtTheStartOfATickOnly) {
  Stage stage(Main(R"(<Sequence><Leaf name="post"/><Drive goal="{g}" total="{t}" )"
                   R"(distance="{d}"/></Sequence>)"));
  const Sender<double> goal = stage.executor->Writer<double>("g");
  const auto distance = [&] {
    return stage.executor->blackboard()[stage.program->layout.Find(kMainScope, "d")]
        .value.Get<double>();
  };
  goal.Send(1);
  stage.script.on_tick["post"] = [goal] { goal.Send(100); };
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(distance(), 2) << "what is posted during a tick is not seen in it";
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(distance(), 200);
}

TEST(Executor, TheNewestMessageWinsAndAllCount) {
  Stage stage(Main(R"(<Drive goal="{g}" total="{t}"/>)"));
  const Sender<double> goal = stage.executor->Writer<double>("g");
  goal.Send(1);
  goal.Send(2);
  stage.executor->Tick();
  const Slot& slot = stage.executor->blackboard()[stage.program->layout.Find(kMainScope, "g")];
  EXPECT_EQ(slot.value.Get<double>(), 2);
  EXPECT_EQ(slot.writes, 2U);
}

TEST(Executor, MessagesFromAnotherThreadWakeAndArrive) {
  Stage stage(Main(R"(<Drive goal="{g}" total="{t}"/>)"));
  std::thread sensor([goal = stage.executor->Writer<double>("g")] { goal.Send(3); });
  EXPECT_TRUE(stage.executor->wake_up().WaitFor(seconds(10)));
  sensor.join();
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
}

TEST(Executor, WriterOfAnUnusedKeyDrops) {
  Stage stage(Main("<AlwaysSuccess/>"));
  EXPECT_FALSE(stage.executor->Writer<double>("nobody"));
}

TEST(Executor, WriterOfAnotherTypeThrows) {
  Stage stage(Main(R"(<Drive goal="{g}" total="{t}"/>)"));
  try {
    stage.executor->Writer<int>("g");
    FAIL() << "did not throw";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), R"(key "g" is double in the tree, not int)");
  }
}

TEST(Executor, ExceptionsBecomeFailuresWithTheirText) {
  Stage stage(Main(R"(<Fallback><Leaf name="a"/><Leaf name="b"/></Fallback>)"));
  stage.script.on_tick["a"] = [] { throw std::runtime_error("no map"); };
  stage.script.on_tick["b"] = [] { throw 5; };
  const KeepingSink& sink = stage.Listen();
  EXPECT_EQ(stage.executor->Tick(), kFailure);
  const auto& messages = sink.ticks[0].messages;
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].node, 1U);
  EXPECT_EQ(messages[0].text, "no map");
  EXPECT_EQ(messages[1].node, 2U);
  EXPECT_EQ(messages[1].text, "threw something that is not a std::exception");
}

TEST(Executor, ExceptionsWhileHaltingAreReportedAndTheRestIsHalted) {
  Stage stage(Main(R"(<Parallel><Leaf name="a"/><Leaf name="b"/><Leaf name="c"/></Parallel>)"),
              WithResults({{"a", {kRunning}}, {"b", {kRunning}}, {"c", {kRunning}}}));
  stage.script.on_halt["a"] = [] { throw std::runtime_error("stuck"); };
  stage.script.on_halt["b"] = [] { throw 5; };
  const KeepingSink& sink = stage.Listen();
  stage.executor->Tick();
  stage.TakeEvents();
  stage.executor->Halt();
  EXPECT_EQ(stage.TakeEvents(), (Events{"halt a", "halt b", "halt c"}));
  ASSERT_EQ(sink.ticks[1].messages.size(), 2U);
  EXPECT_EQ(sink.ticks[1].messages[0].text, "while halting: stuck");
}

TEST(Executor, IdleIsNoResult) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), WithResults({{"a", {Status::kIdle}}}));
  const KeepingSink& sink = stage.Listen();
  EXPECT_EQ(stage.executor->Tick(), kFailure);
  EXPECT_EQ(sink.ticks[0].messages[0].text, "returned IDLE, which no node may");
}

TEST(Executor, TimeoutIsExact) {
  Stage stage(Main(R"(<Timeout msec="100"><Leaf name="a"/></Timeout>)"),
              WithResults({{"a", {kRunning}}}));
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->next_tick(), Time(seconds(1) + milliseconds(100)));
  stage.clock.Advance(milliseconds(100) - Duration(1));
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  stage.clock.Advance(Duration(1));
  stage.TakeEvents();
  EXPECT_EQ(stage.executor->Tick(), kFailure);
  EXPECT_EQ(stage.TakeEvents(), Events{"halt a"}) << "not ticked once more";
}

TEST(Executor, DelayIsExact) {
  Stage stage(Main(R"(<Delay delay_msec="100"><AlwaysSuccess/></Delay>)"));
  stage.clock.Advance(Duration(1));  // an odd start
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->next_tick(), Time(seconds(1) + milliseconds(100) + Duration(1)));
  stage.clock.Advance(milliseconds(100) - Duration(1));
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  stage.clock.Advance(Duration(1));
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
}

TEST(Executor, TheNearestTimerDecidesTheNextTick) {
  Stage stage(Main(R"(<Parallel><Delay delay_msec="300"><AlwaysSuccess/></Delay>)"
                   R"(<Delay delay_msec="200"><AlwaysSuccess/></Delay></Parallel>)"));
  stage.executor->Tick();
  EXPECT_EQ(stage.executor->next_tick(), Time(seconds(1) + milliseconds(200)));
}

TEST(Executor, WithoutTimersNothingIsDue) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), WithResults({{"a", {kRunning}}}));
  stage.executor->Tick();
  EXPECT_EQ(stage.executor->next_tick(), kNever);
}

TEST(Executor, AYieldingLoopIsDueAtOnce) {
  Stage stage(Main(R"(<Repeat num_cycles="2"><AlwaysSuccess/></Repeat>)"));
  EXPECT_EQ(stage.executor->Tick(), kRunning);
  EXPECT_EQ(stage.executor->next_tick(), Time{});
  EXPECT_EQ(stage.executor->Tick(), kSuccess);
  EXPECT_EQ(stage.executor->next_tick(), kNever);
}

TEST(Executor, CallsRunOnTheTickingThreadBetweenTicks) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), WithResults({{"a", {kRunning}}}));
  stage.executor->Tick();
  std::thread::id ran_on;
  std::thread client([&] {
    stage.executor->inbox()->PostCall([&] {
      ran_on = std::this_thread::get_id();
      EXPECT_EQ(stage.executor->statuses()[0], kRunning);
    });
  });
  client.join();
  stage.executor->RunCalls();
  EXPECT_EQ(ran_on, std::this_thread::get_id());
}

TEST(Executor, SinksGetChangesInTheOrderOfHappening) {
  Stage stage(Main(R"(<Inverter><Leaf name="a"/></Inverter>)"),
              WithResults({{"a", {kRunning, kFailure}}}));
  const KeepingSink& sink = stage.Listen();
  stage.executor->Tick();
  stage.executor->Tick();
  ASSERT_EQ(sink.ticks.size(), 2U);
  const auto same = [](const StatusChange& change, NodeIndex node, Status from, Status to) {
    return change.node == node && change.from == from && change.to == to;
  };
  const auto& first = sink.ticks[0];
  EXPECT_EQ(first.tick, 1U);
  EXPECT_EQ(first.start, Time(seconds(1)));
  EXPECT_EQ(first.result, kRunning);
  ASSERT_EQ(first.changes.size(), 2U);
  EXPECT_TRUE(same(first.changes[0], NodeIndex{1}, Status::kIdle, kRunning));
  EXPECT_TRUE(same(first.changes[1], kRootNode, Status::kIdle, kRunning));
  const auto& second = sink.ticks[1];
  ASSERT_EQ(second.changes.size(), 3U);
  EXPECT_TRUE(same(second.changes[0], NodeIndex{1}, kRunning, kFailure));
  EXPECT_TRUE(same(second.changes[1], NodeIndex{1}, kFailure, Status::kIdle));
  EXPECT_TRUE(same(second.changes[2], kRootNode, kRunning, kSuccess));
}

TEST(Executor, AHaltIsReportedWithTheTickBefore) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), WithResults({{"a", {kRunning}}}));
  const KeepingSink& sink = stage.Listen();
  stage.executor->Tick();
  stage.executor->Halt();
  stage.executor->Halt();
  ASSERT_EQ(sink.ticks.size(), 2U) << "halting what is idle is no event";
  EXPECT_EQ(sink.ticks[1].tick, 1U);
  EXPECT_EQ(sink.ticks[1].result, Status::kIdle);
}

TEST(Executor, SinksGetEveryWriteOfASlot) {
  Stage stage(Main(R"(<Sequence><Tell text="1" to="{k}"/><Tell text="2" to="{k}"/></Sequence>)"));
  const KeepingSink& sink = stage.Listen();
  stage.executor->Tick();
  const SlotIndex k = stage.program->layout.Find(kMainScope, "k");
  EXPECT_EQ(sink.ticks[0].writes, (std::vector<SlotIndex>{k, k}));
}

TEST(Executor, ARemovedSinkGetsNothing) {
  Stage stage(Main("<AlwaysSuccess/>"));
  const KeepingSink& sink = stage.Listen();
  stage.executor->RemoveSink(&stage.sink);
  stage.executor->Tick();
  EXPECT_TRUE(sink.ticks.empty());
}

// Asks a question in OnStart and waits for the answer; remembers who asked.
class Ask : public Action {
 public:
  static constexpr const char* kDescription = "Asks.";
  Mailbox<int> answer{this, "answer"};
  explicit Ask(std::vector<Sender<int>>& senders) : senders_(senders) {}
  Status OnStart() override {
    senders_.push_back(answer.NewSender());
    return Status::kRunning;
  }
  Status OnRunning() override {
    const int* number = answer.Take();
    if (!number) return Status::kRunning;
    return *number > 0 ? Status::kSuccess : Status::kFailure;
  }
  void OnHalted() override {}

 private:
  std::vector<Sender<int>>& senders_;
};

TEST(Executor, MailboxesNeverSeeAnswersToEarlierActivations) {
  std::vector<Sender<int>> senders;
  auto registry = std::make_shared<Registry>();
  registry->Register<Ask>("Ask", std::ref(senders));
  Diagnostics diagnostics;
  const auto program = CompileText(Main("<Ask/>"), diagnostics, registry);
  ASSERT_TRUE(program) << diagnostics.ToString();
  SimulatedClock clock;
  Executor executor(program, clock);
  executor.Tick();
  executor.Halt();
  executor.Tick();
  senders[0].Send(-1);
  EXPECT_EQ(executor.Tick(), kRunning) << "the stale answer is dropped";
  senders[1].Send(1);
  senders[0].Send(-1);
  EXPECT_EQ(executor.Tick(), kSuccess) << "also when it comes later";
}

}  // namespace
}  // namespace coppice
