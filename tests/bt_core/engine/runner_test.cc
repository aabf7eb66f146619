#include "bt_core/engine/runner.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

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
  Stage stage(Main(R"(<Delay delay_msec="250"><AlwaysFailure/></Delay>)"));
  EXPECT_EQ(coppice::Run(*stage.executor), Status::kFailure);
  EXPECT_EQ(stage.clock.Now(), Time(seconds(1) + milliseconds(250)));
}

TEST(Runner, SleepsUntilTheNextTimerOnly) {
  Stage stage(Main(R"(<Delay delay_msec="250"><AlwaysSuccess/></Delay>)"));
  coppice::Run(*stage.executor, {Pace::kEvents, kForever});
  EXPECT_EQ(stage.executor->ticks(), 2U);
}

TEST(Runner, TicksAtLeastOncePerPeriod) {
  Stage stage(Main(R"(<Delay delay_msec="250"><AlwaysSuccess/></Delay>)"));
  coppice::Run(*stage.executor, {Pace::kEvents, milliseconds(100)});
  EXPECT_EQ(stage.executor->ticks(), 4U) << "at 0, 100, 200 and 250 ms";
}

TEST(Runner, ForEverStartsAgain) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  Runner runner(*stage.executor, {Pace::kEvents, milliseconds(10), true});
  int ticks = 0;
  stage.script.on_tick["a"] = [&] {
    if (++ticks == 5) runner.RequestStop();
  };
  EXPECT_EQ(runner.Run(), Status::kSuccess);
  EXPECT_EQ(ticks, 5);
}

// Runs a tree of one leaf that never ends on a thread of its own.
class RunnerThread : public testing::Test {
 protected:
  void Start(RunOptions options) {
    runner_ = std::make_unique<Runner>(*stage_.executor, options);
    stage_.script.on_tick["a"] = [this] {
      ticks_ = ticks_ + 1;
      ticked_.Notify();
    };
    thread_ = std::thread([this] { result_ = runner_->Run(); });
  }
  void AwaitTick() { ASSERT_TRUE(ticked_.WaitFor(seconds(30))); }
  void TearDown() override {
    runner_->Stop();
    if (thread_.joinable()) thread_.join();
  }

  Stage stage_{Main(R"(<ReactiveFallback><Drive goal="{g}" total="{t}"/><Leaf name="a"/>)"
                    "</ReactiveFallback>"),
               Running("a")};
  std::unique_ptr<Runner> runner_;
  std::atomic<int> ticks_{0};
  WakeUp ticked_;
  Status result_ = Status::kIdle;
  std::thread thread_;
};

TEST_F(RunnerThread, TheTreeIsHaltedWhenStopReturns) {
  Start({Pace::kEvents, kForever});
  AwaitTick();
  runner_->Stop();
  EXPECT_EQ(stage_.executor->statuses()[0], Status::kIdle);
  EXPECT_EQ(stage_.script.events.back(), "halt a");
}

TEST_F(RunnerThread, AMessageWakesATreeWithoutTimers) {
  Start({Pace::kEvents, kForever});
  AwaitTick();
  stage_.executor->Writer<double>("g").Send(1);
  thread_.join();
  EXPECT_EQ(result_, Status::kSuccess);
}

TEST_F(RunnerThread, ARequestedTickWakesATreeWithoutTimers) {
  Start({Pace::kEvents, kForever});
  for (int i = 1; i <= 100; ++i) {
    AwaitTick();
    EXPECT_EQ(ticks_, i);
    stage_.executor->inbox()->RequestTick();
  }
  AwaitTick();
}

TEST_F(RunnerThread, CallsAreServedWithoutATick) {
  Start({Pace::kEvents, kForever});
  AwaitTick();
  WakeUp called;
  for (int i = 0; i < 10; ++i) {
    stage_.executor->inbox()->PostCall([&] { called.Notify(); });
    ASSERT_TRUE(called.WaitFor(seconds(30)));
  }
  runner_->Stop();
  EXPECT_EQ(ticks_, 1);
}

TEST_F(RunnerThread, AMessageDoesNotDisturbAFixedRate) {
  Start({Pace::kFixedRate, std::chrono::hours(1)});
  AwaitTick();
  stage_.executor->Writer<double>("unused").Send(1);
  stage_.executor->inbox()->RequestTick();
  while (ticks_ < 10) AwaitTick();
  runner_->Stop();
  const auto hours = stage_.clock.Now().time_since_epoch() / std::chrono::hours(1);
  EXPECT_GE(hours, ticks_ - 1);
}

// Needs a minute to stop, unless an answer comes before.
class Slow : public Action {
 public:
  static constexpr const char* kDescription = "Stops slowly.";
  struct Signals {
    WakeUp started;
    WakeUp halted;
    Sender<bool> answer;
  };
  explicit Slow(Signals* signals) : signals_(*signals) {}
  Mailbox<bool> stopped{this, "stopped"};
  Status OnStart() override {
    signals_.answer = stopped.NewSender();
    signals_.started.Notify();
    return Status::kRunning;
  }
  Status OnRunning() override { return Status::kRunning; }
  void OnHalted() override {
    DrainFor(seconds(60));
    signals_.halted.Notify();
  }
  bool OnDraining() override { return stopped.Take() != nullptr; }

 private:
  Signals& signals_;
};

class SlowLeaf : public testing::Test {
 protected:
  void Make(Clock& clock) {
    auto registry = std::make_shared<Registry>();
    registry->Register<Slow>("Slow", &signals_);
    Diagnostics diagnostics;
    executor_ =
        std::make_unique<Executor>(CompileText(Main("<Slow/>"), diagnostics, registry), clock);
  }
  Slow::Signals signals_;
  WallClock wall_clock_;
  SimulatedClock simulated_clock_;
  std::unique_ptr<Executor> executor_;
};

TEST_F(SlowLeaf, RunEndsWhenItHasStopped) {
  Make(wall_clock_);
  const Time start = wall_clock_.Now();
  Runner runner(*executor_, {Pace::kEvents, kForever});
  std::atomic<bool> ended{false};
  std::thread thread([&] {
    runner.Run();
    ended = true;
  });
  ASSERT_TRUE(signals_.started.WaitFor(seconds(30)));
  runner.RequestStop();
  ASSERT_TRUE(signals_.halted.WaitFor(seconds(30)));
  EXPECT_FALSE(ended);
  signals_.answer.Send(true);
  thread.join();
  EXPECT_FALSE(executor_->is_draining());
  EXPECT_LT(wall_clock_.Now() - start, seconds(60)) << "the answer ended it";
}

TEST_F(SlowLeaf, IsGivenUpAfterItsLimit) {
  Make(simulated_clock_);
  Runner runner(*executor_, {Pace::kEvents, milliseconds(10)});
  executor_->inbox()->PostCall([&runner] { runner.RequestStop(); });
  EXPECT_EQ(runner.Run(), Status::kRunning);
  EXPECT_EQ(simulated_clock_.Now(), Time(seconds(60)));
  EXPECT_FALSE(executor_->is_draining());
}

TEST(Runner, StopHaltsTheTree) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Running("a"));
  Runner runner(*stage.executor);
  int ticks = 0;
  stage.script.on_tick["a"] = [&] {
    if (++ticks == 3) runner.Stop();  // in the ticking thread: cannot wait
  };
  EXPECT_EQ(runner.Run(), Status::kRunning);
  EXPECT_EQ(stage.script.events.back(), "halt a");
  EXPECT_EQ(stage.executor->ticks(), 3U);
}

TEST(Runner, StoppedBeforeItRunsItDoesNotTick) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  Runner runner(*stage.executor);
  runner.Stop();
  EXPECT_EQ(runner.Run(), Status::kIdle);
  EXPECT_EQ(stage.executor->ticks(), 0U);
}

TEST(Runner, TheScheduleOfAFixedRateIsAnchoredAtTheFirstTick) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Running("a"));
  Runner runner(*stage.executor, {Pace::kFixedRate, milliseconds(100)});
  std::vector<Duration> starts;
  stage.script.on_tick["a"] = [&] {
    starts.push_back(stage.clock.Now() - Time(seconds(1)));
    stage.clock.Advance(milliseconds(30));  // what the tick takes
    if (starts.size() == 4) runner.RequestStop();
  };
  runner.Run();
  EXPECT_EQ(starts, (std::vector<Duration>{milliseconds(0), milliseconds(100), milliseconds(200),
                                           milliseconds(300)}));
  EXPECT_EQ(runner.overruns(), 0U);
}

TEST(Runner, AFixedRateLeavesOutThePeriodsThatATickMisses) {
  Stage stage(Main(R"(<Leaf name="a"/>)"), Running("a"));
  Runner runner(*stage.executor, {Pace::kFixedRate, milliseconds(100)});
  std::vector<Duration> starts;
  stage.script.on_tick["a"] = [&] {
    starts.push_back(stage.clock.Now() - Time(seconds(1)));
    stage.clock.Advance(milliseconds(starts.size() == 1 ? 350 : 100));
    if (starts.size() == 3) runner.RequestStop();
  };
  runner.Run();
  EXPECT_EQ(starts, (std::vector<Duration>{milliseconds(0), milliseconds(400), milliseconds(500)}));
  EXPECT_EQ(runner.overruns(), 1U) << "a tick that takes exactly a period is in time";
  EXPECT_EQ(runner.missed_periods(), 3U) << "100, 200 and 300 ms";
}

TEST(Runner, AFixedRateDoesNotListenToTimers) {
  Stage stage(Main(R"(<Delay delay_msec="250"><AlwaysSuccess/></Delay>)"));
  coppice::Run(*stage.executor, {Pace::kFixedRate, milliseconds(100)});
  EXPECT_EQ(stage.clock.Now(), Time(seconds(1) + milliseconds(300)));
  EXPECT_EQ(stage.executor->ticks(), 4U);
}

TEST(Runner, AFixedRateNeedsAPeriod) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  for (const Duration period : {Duration(0), Duration(-1), kForever}) {
    EXPECT_THROW(Runner(*stage.executor, {Pace::kFixedRate, period}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace coppice
