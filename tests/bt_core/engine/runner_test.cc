#include "bt_core/engine/runner.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

LeafScript Running(const std::string& leaf) {
  LeafScript script;
  script.results[leaf] = {Status::kRunning};
  return script;
}

TEST(Runner, RunsUntilTheRootCompletes) {
  Stage stage(Main("<Delay delay_msec=\"250\"><AlwaysFailure/></Delay>"));
  const std::atomic<bool> stop{false};
  EXPECT_EQ(coppice::Run(*stage.executor, RunOptions(), stop), Status::kFailure);
  EXPECT_EQ(stage.clock.Now(), seconds(1) + milliseconds(250));
}

TEST(Runner, SleepsUntilTheNextTimerOnly) {
  Stage stage(Main("<Delay delay_msec=\"250\"><AlwaysSuccess/></Delay>"));
  const std::atomic<bool> stop{false};
  coppice::Run(*stage.executor, {kNever, false}, stop);
  EXPECT_EQ(stage.executor->ticks(), 2U);
}

TEST(Runner, TicksAtLeastOncePerPeriod) {
  Stage stage(Main("<Delay delay_msec=\"250\"><AlwaysSuccess/></Delay>"));
  const std::atomic<bool> stop{false};
  coppice::Run(*stage.executor, {milliseconds(100), false}, stop);
  EXPECT_EQ(stage.executor->ticks(), 4U) << "at 0, 100, 200 and 250 ms";
}

TEST(Runner, StopHaltsTheTree) {
  Stage stage(Main("<Leaf name=\"a\"/>"), Running("a"));
  std::atomic<bool> stop{false};
  int ticks = 0;
  stage.script.on_tick["a"] = [&] { stop = ++ticks == 3; };
  EXPECT_EQ(coppice::Run(*stage.executor, RunOptions(), stop), Status::kRunning);
  EXPECT_EQ(stage.script.events.back(), "halt a");
  EXPECT_EQ(stage.executor->ticks(), 3U);
}

TEST(Runner, StopFromAnotherThreadEndsASleepWithoutPeriod) {
  Stage stage(Main("<Leaf name=\"a\"/>"), Running("a"));
  std::atomic<bool> stop{false};
  std::atomic<bool> ticked{false};
  stage.script.on_tick["a"] = [&] { ticked = true; };
  std::thread stopper([&] {
    while (!ticked) std::this_thread::yield();
    stop = true;
    stage.executor->wake_up().Notify();
  });
  coppice::Run(*stage.executor, {kNever, false}, stop);
  stopper.join();
  EXPECT_EQ(stage.executor->statuses()[0], Status::kIdle);
}

TEST(Runner, ForEverStartsAgain) {
  Stage stage(Main("<Leaf name=\"a\"/>"));
  std::atomic<bool> stop{false};
  int ticks = 0;
  stage.script.on_tick["a"] = [&] { stop = ++ticks == 5; };
  EXPECT_EQ(coppice::Run(*stage.executor, {milliseconds(10), true}, stop), Status::kSuccess);
  EXPECT_EQ(ticks, 5);
}

TEST(Runner, AMessageWakesATreeWithoutTimers) {
  Stage stage(Main("<ReactiveFallback><Drive goal=\"{g}\" total=\"{t}\"/><Leaf name=\"a\"/>"
                   "</ReactiveFallback>"),
              Running("a"));
  const std::atomic<bool> stop{false};
  std::atomic<bool> ticked{false};
  stage.script.on_tick["a"] = [&] { ticked = true; };
  std::thread sensor([&, goal = stage.executor->Writer<double>("g")] {
    while (!ticked) std::this_thread::yield();
    goal.Send(1);
  });
  EXPECT_EQ(coppice::Run(*stage.executor, {kNever, false}, stop), Status::kSuccess);
  sensor.join();
}

TEST(Runner, CallsAreServedWithoutATick) {
  Stage stage(Main("<Leaf name=\"a\"/>"), Running("a"));
  std::atomic<bool> stop{false};
  stage.executor->inbox()->PostCall([] {});
  stage.script.on_tick["a"] = [&] { stage.executor->inbox()->PostCall([&] { stop = true; }); };
  coppice::Run(*stage.executor, {kNever, false}, stop);
  EXPECT_EQ(stage.executor->ticks(), 1U);
}

}  // namespace
}  // namespace coppice
