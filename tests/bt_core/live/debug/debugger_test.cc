#include "bt_core/live/debug/debugger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/engine/runner.h"
#include "tests/bt_core/live/debugged_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr Status kRunning = Status::kRunning;
constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;
constexpr Status kIdle = Status::kIdle;
using Where = DebugStop::Where;

// Nodes: Sequence 0, a 1, b 2.
const char kTwo[] = R"(<Sequence><Leaf name="a"/><Leaf name="b"/></Sequence>)";

TEST(Debugger, StopsBeforeANodeUntilItIsContinued) {
  DebuggedTree tree(Main(kTwo));
  const HookId id = tree.Set(NodeIndex{2});
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "before 2");
  const DebugStop stop = tree.debugger->where();
  EXPECT_EQ(stop.where, Where::kBefore);
  EXPECT_EQ(stop.hook, id);
  EXPECT_EQ(stop.tick, 1u);
  EXPECT_EQ(tick.wait_for(0s), std::future_status::timeout);
  tree.debugger->Continue();
  EXPECT_EQ(tree.NextText(), "resumed");
  EXPECT_EQ(tick.get(), kSuccess);
  EXPECT_EQ(tree.debugger->where().where, Where::kNowhere);
  EXPECT_THAT(tree.stage.TakeEvents(), ElementsAre("start a", "start b"));
}

TEST(Debugger, ShowsTheWatchersHowFarTheTickHasCome) {
  DebuggedTree tree(Main(kTwo));
  const KeepingSink& sink = tree.stage.Listen();
  tree.Set(NodeIndex{2});
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "before 2");
  ASSERT_EQ(sink.ticks.size(), 1u);
  EXPECT_EQ(sink.statuses(), (std::vector<Status>{kIdle, kSuccess, kIdle}));
  tree.debugger->Continue();
  EXPECT_EQ(tick.get(), kSuccess);
  EXPECT_EQ(sink.ticks.size(), 2u);
}

TEST(Debugger, StopsAfterANodeWithItsResult) {
  DebuggedTree tree(Main(kTwo));
  tree.Set(NodeIndex{1}, HookPosition::kAfter);
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "after 1 SUCCESS");
  tree.debugger->Continue(kFailure);
  EXPECT_EQ(tick.get(), kFailure);
  EXPECT_THAT(tree.stage.TakeEvents(), ElementsAre("start a"));
}

TEST(Debugger, ContinuesAsIfTheNodeHadReturnedAStatus) {
  DebuggedTree tree(Main(kTwo));
  tree.Set(NodeIndex{1});
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "before 1");
  tree.debugger->Continue(kSuccess);
  EXPECT_EQ(tick.get(), kSuccess);
  EXPECT_THAT(tree.stage.TakeEvents(), ElementsAre("start b"));
}

struct HookCase {
  const char* what;
  std::function<void(Hook&)> change;
  std::vector<const char*> told;  // in five ticks, all stops being continued
};

class DebuggerHook : public ::testing::TestWithParam<HookCase> {};

TEST_P(DebuggerHook, ActsWhenItShould) {
  // Node 2 is the one with hooks; k is 1 in the first tick.
  DebuggedTree tree(
      Main(R"(<Sequence><Script code="k := n + 1; n := k"/><Leaf name="b"/></Sequence>)"));
  tree.stage.executor->Writer<double>("n").Send(0);
  Hook hook;
  hook.node = NodeIndex{2};
  GetParam().change(hook);
  const Expected<HookAnswer> answer = tree.debugger->Add(hook);
  ASSERT_TRUE(answer.ok()) << answer.problem();
  std::future<Status> ticks = tree.Tick(5);
  std::vector<std::string> told;
  while (ticks.wait_for(0s) != std::future_status::ready || tree.told() > 0) {
    if (tree.told() == 0) {
      std::this_thread::yield();
      continue;
    }
    told.push_back(tree.NextText());
    tree.debugger->Continue();
  }
  EXPECT_EQ(told, std::vector<std::string>(GetParam().told.begin(), GetParam().told.end()));
}

INSTANTIATE_TEST_SUITE_P(
    All, DebuggerHook,
    ::testing::Values(HookCase{"Disabled", [](Hook& h) { h.enabled = false; }, {}},
                      HookCase{"FromTheFourthHit",
                               [](Hook& h) { h.from_hit = 4; },
                               {"before 2", "resumed", "before 2", "resumed"}},
                      HookCase{"Once", [](Hook& h) { h.times = 1; }, {"before 2", "resumed"}},
                      HookCase{"OnceAtTheThirdHit",
                               [](Hook& h) {
                                 h.from_hit = 3;
                                 h.times = 1;
                               },
                               {"before 2", "resumed"}},
                      HookCase{"IfTheConditionHolds",
                               [](Hook& h) { h.condition = "k >= 4"; },
                               {"before 2", "resumed", "before 2", "resumed"}},
                      HookCase{"WhatTheConditionForbidsIsNoHit",
                               [](Hook& h) {
                                 h.condition = "k >= 3";
                                 h.from_hit = 3;
                               },
                               {"before 2", "resumed"}},
                      HookCase{"ReplacesTwice",
                               [](Hook& h) {
                                 h.action = HookAction::kReplace;
                                 h.status = kFailure;
                                 h.times = 2;
                               },
                               {"replaced 2 FAILURE", "replaced 2 FAILURE"}},
                      HookCase{"ReplacesAfterwards",
                               [](Hook& h) {
                                 h.action = HookAction::kReplace;
                                 h.position = HookPosition::kAfter;
                                 h.status = kFailure;
                                 h.from_hit = 5;
                               },
                               {"replaced 2 FAILURE"}}),
    [](const auto& info) { return info.param.what; });

TEST(Debugger, KeepsANodeRunningForADelayAndTicksItThen) {
  DebuggedTree tree(Main(kTwo));
  Hook hook;
  hook.path = "b";
  hook.action = HookAction::kDelay;
  hook.delay = 2s;
  hook.times = 1;
  ASSERT_TRUE(tree.debugger->Add(hook).ok());
  EXPECT_EQ(tree.stage.executor->Tick(), kRunning);
  EXPECT_EQ(tree.stage.executor->next_tick(), Time(3s));
  tree.stage.clock.Advance(1s);
  EXPECT_EQ(tree.stage.executor->Tick(), kRunning);
  EXPECT_THAT(tree.stage.TakeEvents(), ElementsAre("start a"));
  tree.stage.clock.Advance(1s);
  EXPECT_EQ(tree.stage.executor->Tick(), kSuccess);
  EXPECT_THAT(tree.stage.TakeEvents(), ElementsAre("start b"));
  EXPECT_TRUE(tree.debugger->hooks().empty());
}

TEST(Debugger, BeginsADelayAnewWhenTheNodeWasHalted) {
  DebuggedTree tree(Main(kTwo));
  Hook hook;
  hook.node = NodeIndex{2};
  hook.action = HookAction::kDelay;
  hook.delay = 2s;
  EXPECT_TRUE(tree.debugger->Add(hook));
  EXPECT_EQ(tree.stage.executor->Tick(), kRunning);
  tree.stage.executor->Halt();
  tree.stage.clock.Advance(3s);
  EXPECT_EQ(tree.stage.executor->Tick(), kRunning);
  EXPECT_THAT(tree.stage.TakeEvents(), ElementsAre("start a", "start a"));  // b is not halted
  tree.stage.clock.Advance(3s);
  EXPECT_EQ(tree.stage.executor->Tick(), kSuccess);
}

TEST(Debugger, PausesBeforeTheNextTickAndServesCallsMeanwhile) {
  DebuggedTree tree(Main(kTwo));
  tree.stage.executor->Tick();
  EXPECT_EQ(tree.debugger->Pause().problem(), "");
  EXPECT_TRUE(tree.debugger->is_pausing());
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "between 1");
  std::promise<std::uint64_t> ticks;
  tree.stage.executor->inbox()->PostCall([&] { ticks.set_value(tree.stage.executor->ticks()); });
  EXPECT_EQ(ticks.get_future().get(), 1u);
  tree.debugger->Continue();
  EXPECT_EQ(tick.get(), kSuccess);
  EXPECT_FALSE(tree.debugger->is_pausing());
}

TEST(Debugger, StepsFromNodeToNodeAndToTheEndOfTheTick) {
  DebuggedTree tree(Main(kTwo));
  EXPECT_TRUE(tree.debugger->Pause());
  std::future<Status> ticks = tree.Tick(2);
  const std::vector<std::string> expected = {"between 0", "before 0",  "before 1",
                                             "before 2",  "between 1", "before 0"};
  for (const std::string& stop : expected) {
    EXPECT_EQ(tree.NextText(), stop);
    EXPECT_TRUE(tree.debugger->StepNode());
    EXPECT_EQ(tree.NextText(), "resumed");
  }
  EXPECT_EQ(tree.NextText(), "before 1");
  tree.debugger->Continue();
  EXPECT_EQ(ticks.get(), kSuccess);
}

TEST(Debugger, StepsIntoNodesFromABreakpointInTheMiddleOfATick) {
  DebuggedTree tree(Main(R"(<Sequence><Leaf name="a"/><Inverter><Leaf name="b"/></Inverter>)"
                         R"(<Leaf name="c"/></Sequence>)"),
                    {});
  tree.Set(NodeIndex{1});
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "before 1");
  EXPECT_TRUE(tree.debugger->StepNode());
  tree.NextText();
  EXPECT_EQ(tree.NextText(), "before 2");
  EXPECT_TRUE(tree.debugger->StepNode());
  tree.NextText();
  EXPECT_EQ(tree.NextText(), "before 3");
  tree.debugger->Continue();
  EXPECT_EQ(tick.get(), kFailure);
  // The nodes of the step are no longer chosen.
  std::future<Status> next = tree.Tick();
  tree.NextText();
  EXPECT_EQ(tree.NextText(), "before 1");
  tree.debugger->Continue();
  EXPECT_EQ(next.get(), kFailure);
  EXPECT_EQ(tree.NextText(), "resumed");
  EXPECT_EQ(tree.told(), 0u);
}

TEST(Debugger, StepsWholeTicks) {
  DebuggedTree tree(Main(kTwo));
  EXPECT_TRUE(tree.debugger->Pause());
  std::future<Status> ticks = tree.Tick(3);
  EXPECT_EQ(tree.NextText(), "between 0");
  EXPECT_TRUE(tree.debugger->StepTick());
  EXPECT_EQ(tree.NextText(), "resumed");
  EXPECT_EQ(tree.NextText(), "between 1");
  EXPECT_THAT(tree.stage.TakeEvents(), ElementsAre("start a", "start b"));
  tree.debugger->Continue();
  EXPECT_EQ(ticks.get(), kSuccess);
}

TEST(Debugger, StopsATreeThatSleepsUntilSomethingHappens) {
  LeafScript script;
  script.results["a"] = {kRunning};
  DebuggedTree tree(Main(R"(<Leaf name="a"/>)"), script);
  Runner runner(*tree.stage.executor);
  std::thread thread([&] { runner.Run(); });
  EXPECT_TRUE(tree.debugger->Pause());
  EXPECT_EQ(tree.Next().kind, DebugEvent::Kind::kStopped);
  EXPECT_TRUE(tree.debugger->StepTick());
  EXPECT_EQ(tree.NextText(), "resumed");
  EXPECT_EQ(tree.Next().kind, DebugEvent::Kind::kStopped);
  tree.debugger->Continue();
  runner.Stop();
  thread.join();
}

TEST(Debugger, ReleasesWhatAClientOwnsAndNothingElse) {
  DebuggedTree tree(Main(kTwo));
  Hook hook;
  hook.node = NodeIndex{1};
  const HookId mine = tree.debugger->Add(hook, 7)->id;
  hook.node = NodeIndex{2};
  const HookId other = tree.debugger->Add(hook, 8)->id;
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "before 1");
  tree.debugger->Release(8);  // stands still: it is not its stop
  EXPECT_FALSE(tree.debugger->Find(other));
  EXPECT_EQ(tree.debugger->where().hook, mine);
  tree.debugger->Release(7);
  EXPECT_EQ(tick.get(), kSuccess);
  EXPECT_TRUE(tree.debugger->hooks().empty());
}

TEST(Debugger, ReleasesAPauseOfAClientThatDied) {
  DebuggedTree tree(Main(kTwo));
  EXPECT_TRUE(tree.debugger->Pause(7));
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "between 0");
  tree.debugger->Release(8);
  EXPECT_EQ(tree.debugger->where().where, Where::kBetweenTicks);
  tree.debugger->Release(7);
  EXPECT_EQ(tick.get(), kSuccess);
}

TEST(Debugger, LetsTheTreeGoOnWhenTheHookIsRemovedDisabledOrChanged) {
  for (const std::string how : {"removed", "disabled", "changed"}) {
    DebuggedTree tree(Main(kTwo));
    const HookId id = tree.Set(NodeIndex{2});
    std::future<Status> tick = tree.Tick();
    EXPECT_EQ(tree.NextText(), "before 2");
    Hook other;
    other.node = NodeIndex{1};
    if (how == "removed") tree.debugger->Remove(id);
    if (how == "disabled") tree.debugger->SetEnabled(id, false);
    if (how == "changed") static_cast<void>(tree.debugger->Change(id, other));
    EXPECT_EQ(tick.get(), kSuccess) << how;
  }
}

TEST(Debugger, RefusesEverythingThatStopsOrChangesTheTreeWithTheReason) {
  DebuggedTree tree(Main(kTwo));
  const HookId id = tree.Set(NodeIndex{1});
  tree.Refuse("the robot moves");
  Hook hook;
  hook.node = NodeIndex{2};
  EXPECT_EQ(tree.debugger->Add(hook).problem(), "the robot moves");
  EXPECT_FALSE(tree.debugger->Add(hook).ok());
  EXPECT_EQ(tree.debugger->Change(id, hook).problem(), "the robot moves");
  EXPECT_EQ(tree.debugger->Pause().problem(), "the robot moves");
  EXPECT_EQ(tree.debugger->StepNode().problem(), "the robot moves");
  EXPECT_EQ(tree.debugger->StepTick().problem(), "the robot moves");
  EXPECT_EQ(tree.Tick().get(), kSuccess);  // a breakpoint from before does not stop it either
  EXPECT_EQ(tree.NextText(), "refused the robot moves");
  EXPECT_TRUE(tree.debugger->Remove(id));
}

TEST(Debugger, FindsItsNodesAgainInATreeThatIsSwappedIn) {
  DebuggedTree tree(Main(kTwo));
  Hook hook;
  hook.path = "late";
  const Expected<HookAnswer> answer = tree.debugger->Add(hook);
  EXPECT_TRUE(answer.ok());
  EXPECT_THAT(answer->remark, HasSubstr(R"(no node "late")"));
  const HookId by_number = tree.Set(NodeIndex{2});  // "b"
  EXPECT_TRUE(tree.debugger->Find(answer->id)->nodes.empty());
  Stage next(Main(R"(<Sequence><Leaf name="late"/><Leaf name="a"/><Leaf name="b"/></Sequence>)"));
  tree.stage.executor->inbox()->PostCall([&] { tree.stage.executor->Reload(next.program); });
  std::future<Status> tick = tree.Tick();
  EXPECT_EQ(tree.NextText(), "before 1");
  EXPECT_THAT(tree.debugger->Find(by_number)->nodes, ElementsAre(3u));
  tree.debugger->Continue();
  EXPECT_EQ(tree.NextText(), "resumed");
  EXPECT_EQ(tree.NextText(), "before 3");
  tree.debugger->Continue();
  EXPECT_EQ(tick.get(), kSuccess);
  tree.debugger.reset();
  tree.stage.executor.reset();  // before the leaves of the other stage
}

TEST(Debugger, LetsTheTreeGoOnWhenItEnds) {
  DebuggedTree tree(Main(kTwo));
  tree.Set(NodeIndex{1});
  std::future<Status> ticks = tree.Tick(3);
  EXPECT_EQ(tree.NextText(), "before 1");
  tree.debugger.reset();
  EXPECT_EQ(ticks.get(), kSuccess);
}

TEST(Debugger, MayOutliveTheExecutor) {
  DebuggedTree tree(Main(kTwo));
  tree.Set(NodeIndex{1});
  tree.stage.executor.reset();
  EXPECT_EQ(tree.debugger->Pause().problem(), "");
  tree.debugger.reset();
}

TEST(Debugger, MayBeFollowedByAnother) {
  DebuggedTree tree(Main(kTwo));
  tree.debugger.reset();
  Debugger next(*tree.stage.executor);
  Hook hook;
  hook.node = NodeIndex{1};
  hook.action = HookAction::kReplace;
  hook.status = kFailure;
  ASSERT_TRUE(next.Add(hook).ok());
  EXPECT_EQ(tree.stage.executor->Tick(), kFailure);
}

TEST(Debugger, DoesNotKeepARunnerFromStopping) {
  LeafScript script;
  script.results["a"] = {kRunning};
  DebuggedTree tree(Main(R"(<Leaf name="a"/>)"), script);
  tree.Set(kRootNode);
  Runner runner(*tree.stage.executor);
  std::thread thread([&] { runner.Run(); });
  EXPECT_EQ(tree.NextText(), "before 0");
  runner.Stop();
  thread.join();
  EXPECT_EQ(tree.NextText(), "resumed");
}

// For the thread sanitizer: many clients at once, none of which ends in order.
TEST(Debugger, WithstandsClientsThatPauseInjectAndDie) {
  LeafScript script;
  DebuggedTree tree(Main(kTwo), script);
  std::atomic<bool> done{false};
  std::vector<std::thread> clients;
  for (OwnerId owner = 1; owner <= 8; ++owner) {
    clients.emplace_back([&tree, &done, owner] {
      Debugger& debugger = *tree.debugger;
      for (std::uint32_t round = static_cast<std::uint32_t>(owner); !done; ++round) {
        Hook hook;
        hook.node = NodeIndex(round % 3);
        hook.position = round % 2 ? HookPosition::kAfter : HookPosition::kBefore;
        hook.action = round % 5 ? HookAction::kReplace : HookAction::kStop;
        hook.status = kFailure;
        hook.times = round % 4;
        const HookId id = debugger.Add(hook, owner)->id;
        if (round % 7 == 0) static_cast<void>(debugger.Pause(owner));
        if (round % 11 == 0) static_cast<void>(debugger.StepNode(owner));
        if (round % 13 == 0) debugger.Remove(id);
        debugger.hooks();
        debugger.where();
        debugger.Release(owner);
      }
    });
  }
  for (int i = 0; i < 2000; ++i) tree.stage.executor->Tick();
  done = true;
  for (std::thread& client : clients) client.join();
  tree.stage.script.events.clear();
  EXPECT_EQ(tree.stage.executor->Tick(), kSuccess);
  EXPECT_TRUE(tree.debugger->hooks().empty());
}

}  // namespace
}  // namespace coppice
