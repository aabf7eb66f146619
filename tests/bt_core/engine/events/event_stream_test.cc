#include "bt_core/engine/events/event_stream.h"

#include <gtest/gtest.h>

#include <future>

#include "bt_core/data/value_bytes.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

constexpr Status kRunning = Status::kRunning;

// Keeps what it gets; can be held up in its first tick.
class Keeper : public EventListener {
 public:
  void OnState(const StreamState& state) override { states.push_back(state); }
  void OnTick(const TickEvents& events) override {
    if (entered) std::exchange(entered, nullptr)->set_value();
    if (go_on.valid()) go_on.wait();
    ticks.push_back(events.tick);
    words.push_back(events.words.size);
  }
  std::vector<StreamState> states;
  std::vector<std::uint64_t> ticks;
  std::vector<std::size_t> words;
  std::promise<void>* entered = nullptr;
  std::shared_future<void> go_on;
};

LeafScript Running() {
  LeafScript script;
  script.results = {{"a", {kRunning}}};
  return script;
}

TEST(EventStream, AListenerGetsTheStateAndThenEveryTick) {
  Stage stage(Main(R"(<Sequence><Tell text="hi" to="{k}"/><Leaf name="a"/></Sequence>)"),
              Running());
  stage.executor->Tick();
  EventStream stream(*stage.executor);
  Keeper keeper;
  stream.Add(keeper);
  for (int i = 0; i < 1000; ++i) stage.executor->Tick();
  stream.Remove(keeper);
  ASSERT_EQ(keeper.states.size(), 1U);
  EXPECT_EQ(keeper.states[0].cause, StreamState::Cause::kBegin);
  EXPECT_EQ(keeper.states[0].tick, 1U);
  EXPECT_EQ(keeper.states[0].statuses, stage.executor->statuses());
  const SlotIndex k = stage.program->layout.Find(kMainScope, "k");
  EXPECT_EQ(PrintValueBytes(keeper.states[0].values[k]), "hi");
  ASSERT_EQ(keeper.ticks.size(), 1000U);
  for (std::size_t i = 0; i < keeper.ticks.size(); ++i) EXPECT_EQ(keeper.ticks[i], i + 2);
  EXPECT_EQ(keeper.words[0], 2U);
}

TEST(EventStream, WithoutListenersNothingIsCollected) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  EventStream stream(*stage.executor);
  Keeper keeper;
  stream.Add(keeper);
  stage.executor->Tick();
  stream.Remove(keeper);
  stage.executor->Tick();
  stream.Flush();
  EXPECT_EQ(keeper.ticks.size(), 1U);
}

TEST(EventStream, AListenerThatComesLaterDoesNotDisturbTheFirst) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  EventStream stream(*stage.executor);
  Keeper first;
  Keeper second;
  stream.Add(first);
  stage.executor->Tick();
  stream.Add(second);
  stage.executor->Tick();
  stream.Remove(first);
  stage.executor->Tick();
  stream.Remove(second);
  EXPECT_EQ(first.ticks, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(first.states.size(), 1U);
  EXPECT_EQ(second.ticks, (std::vector<std::uint64_t>{2, 3}));
  EXPECT_EQ(second.states.at(0).tick, 1U);
}

TEST(EventStream, WhatASlowListenerLosesIsCountedAndTheStateBehindItGiven) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Running());
  EventStream stream(*stage.executor, 4096);
  Keeper keeper;
  std::promise<void> entered;
  std::promise<void> go_on;
  keeper.entered = &entered;
  keeper.go_on = go_on.get_future().share();
  stream.Add(keeper);
  stage.executor->Tick();
  entered.get_future().wait();
  for (int i = 0; i < 1000; ++i) stage.executor->Tick();
  EXPECT_GT(stream.lost_ticks(), 0U);
  go_on.set_value();
  stream.Flush();
  stage.executor->Tick();  // now there is room: this tick is the last that is lost
  stage.executor->Tick();
  stream.Remove(keeper);
  ASSERT_EQ(keeper.states.size(), 2U);
  const StreamState& gap = keeper.states[1];
  EXPECT_EQ(gap.cause, StreamState::Cause::kLost);
  EXPECT_EQ(gap.lost_ticks, stream.lost_ticks());
  EXPECT_EQ(gap.last_lost, 1002U);
  EXPECT_EQ(gap.last_lost - gap.first_lost + 1, gap.lost_ticks);
  EXPECT_EQ(gap.tick, gap.last_lost);
  EXPECT_EQ(keeper.ticks.size() + gap.lost_ticks, 1003U) << "nothing is missing silently";
  EXPECT_EQ(keeper.ticks.back(), 1003U);
}

TEST(EventStream, ASwapOfTheTreeIsAStateBetweenItsTicks) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  EventStream stream(*stage.executor);
  Keeper keeper;
  stream.Add(keeper);
  stage.executor->Tick();
  Diagnostics diagnostics;
  const auto next =
      CompileText(Main("<Inverter><AlwaysFailure/></Inverter>"), diagnostics, TestRegistry());
  stage.executor->Reload(next);
  stage.executor->Tick();
  stream.Remove(keeper);
  ASSERT_EQ(keeper.states.size(), 2U);
  EXPECT_EQ(keeper.states[1].cause, StreamState::Cause::kJump);
  EXPECT_EQ(keeper.states[1].program, next);
  EXPECT_EQ(keeper.words, (std::vector<std::size_t>{1, 1, 2})) << "a tick, the reset, a tick";
}

}  // namespace
}  // namespace coppice
