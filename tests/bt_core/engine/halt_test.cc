// Leaves that need several ticks to stop, and what skipped ones have begun.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using Names = std::vector<std::string>;

// What the test and the leaf share.
struct Brake {
  Names events;
  bool stopped = false;
};

class SlowToStop : public Action {
 public:
  static constexpr const char* kDescription = "Stops when the test says so.";
  explicit SlowToStop(Brake* brake) : brake_(*brake) {}
  Status OnStart() override { return Note("start"); }
  Status OnRunning() override { return Note("run"); }
  void OnHalted() override {
    Note("halt");
    DrainFor(std::chrono::seconds(2));
  }
  bool OnDraining() override {
    Note("drain");
    return brake_.stopped;
  }

 private:
  Status Note(const char* what) {
    brake_.events.emplace_back(what);
    return Status::kRunning;
  }
  Brake& brake_;
};

class Draining : public ::testing::Test {
 protected:
  Draining() {
    auto registry = std::make_shared<Registry>();
    registry->Register<SlowToStop>("Slow", &brake_);
    registry->Condition("Go", [this] { return go_; });
    Diagnostics diagnostics;
    const auto program = CompileText(Main("<ReactiveSequence><Go/><Slow/></ReactiveSequence>"),
                                     diagnostics, registry);
    EXPECT_TRUE(program) << diagnostics.ToString();
    executor_ = std::make_unique<Executor>(program, clock_);
    executor_->AddSink(&sink_);
  }
  Status Tick(bool go) {
    go_ = go;
    return executor_->Tick();
  }
  Names Events() { return std::exchange(brake_.events, {}); }

  Brake brake_;
  bool go_ = true;
  SimulatedClock clock_;
  KeepingSink sink_;
  std::unique_ptr<Executor> executor_;
};

TEST_F(Draining, TheTreeGoesOnWhileTheLeafStops) {
  Tick(true);
  EXPECT_EQ(Tick(false), Status::kFailure);
  EXPECT_TRUE(executor_->is_draining());
  EXPECT_EQ(Tick(false), Status::kFailure);
  EXPECT_EQ(Events(), (Names{"start", "halt", "drain"}));
}

TEST_F(Draining, TheLeafIsNotStartedAgainBeforeItHasStopped) {
  Tick(true);
  Tick(false);
  Events();
  EXPECT_EQ(Tick(true), Status::kRunning);
  EXPECT_EQ(executor_->statuses()[2], Status::kRunning);
  EXPECT_EQ(Events(), (Names{"drain"}));
  brake_.stopped = true;
  EXPECT_EQ(Tick(true), Status::kRunning);
  EXPECT_EQ(Events(), (Names{"drain", "start"}));
  EXPECT_FALSE(executor_->is_draining());
}

TEST_F(Draining, AHaltWhileItWaitsToStartIsNotToldToTheLeaf) {
  Tick(true);
  Tick(false);
  Tick(true);
  Events();
  Tick(false);
  EXPECT_EQ(Events(), (Names{"drain"}));
}

TEST_F(Draining, WhatDoesNotStopInTimeIsGivenUpWithAMessage) {
  Tick(true);
  Tick(false);
  clock_.Advance(std::chrono::seconds(2));
  Events();
  Tick(true);
  EXPECT_EQ(Events(), (Names{"drain", "start"}));
  ASSERT_EQ(sink_.ticks.back().messages.size(), 1U);
  EXPECT_EQ(sink_.ticks.back().messages[0].text, "has not stopped in time and is given up");
}

TEST_F(Draining, TheDeadlineWakesTheTree) {
  Tick(true);
  Tick(false);
  Tick(false);
  EXPECT_EQ(executor_->next_tick(), Time(std::chrono::seconds(2)));
}

TEST_F(Draining, CanBeServedWithoutATick) {
  Tick(true);
  executor_->Halt();
  EXPECT_TRUE(executor_->is_draining());
  brake_.stopped = true;
  executor_->ServeDrains();
  EXPECT_FALSE(executor_->is_draining());
  EXPECT_EQ(Events(), (Names{"start", "halt", "drain"}));
}

// RUNNING, then SKIPPED, and the one behind it fails: the sequence keeps its place.
class InFrontOfThePlace : public ::testing::Test {
 protected:
  InFrontOfThePlace()
      : stage_(Main(R"(<Fallback><SequenceWithMemory><Inverter><Leaf name="a"/></Inverter>)"
                    R"(<Leaf name="b"/></SequenceWithMemory><AlwaysSuccess/></Fallback>)"),
               MakeScript()) {
    stage_.executor->Tick();
    EXPECT_EQ(stage_.executor->Tick(), Status::kSuccess);
    EXPECT_EQ(stage_.TakeEvents(), (Names{"start a", "tick a", "start b"}));
  }
  static LeafScript MakeScript() {
    LeafScript script;
    script.results["a"] = {Status::kRunning, Status::kSkipped, Status::kRunning};
    script.results["b"] = {Status::kFailure, Status::kRunning, Status::kSuccess};
    return script;
  }

  Stage stage_;
};

TEST_F(InFrontOfThePlace, ASkippedLeafIsHaltedWhenTheSequenceComesToItsEnd) {
  EXPECT_EQ(stage_.executor->Tick(), Status::kRunning);
  EXPECT_EQ(stage_.executor->Tick(), Status::kSuccess);
  EXPECT_EQ(stage_.TakeEvents(), (Names{"start b", "tick b", "halt a"}));
}

TEST_F(InFrontOfThePlace, ASkippedLeafIsHaltedWithTheSequenceThatRuns) {
  stage_.executor->Tick();
  stage_.executor->Halt();
  EXPECT_EQ(stage_.TakeEvents(), (Names{"start b", "halt a", "halt b"}));
}

TEST_F(InFrontOfThePlace, ASkippedLeafIsHaltedWithTheTree) {
  stage_.executor->Halt();
  EXPECT_EQ(stage_.TakeEvents(), (Names{"halt a"}));
  stage_.executor->Halt();
  EXPECT_EQ(stage_.TakeEvents(), Names{});
}

}  // namespace
}  // namespace coppice
