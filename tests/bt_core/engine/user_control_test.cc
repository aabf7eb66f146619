#include "bt_core/nodes/user_control.h"

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using Events = std::vector<std::string>;

class Alternate : public UserControl {
 public:
  static constexpr const char* kDescription = "Ticks one child per activation, in turn.";
  Status Tick(Children& children, bool starting) override {
    if (starting) current_ = (current_ + 1) % children.size();
    return children.Tick(current_);
  }

 private:
  std::uint32_t current_ = UINT32_MAX;
};

// The reactive sequence of the book, for tests of halting and of what a parent sees.
class Guarded : public UserControl {
 public:
  static constexpr const char* kDescription = "Ticks its children in order, from the first.";
  static constexpr ChildCount kChildren{2, 3};
  explicit Guarded(std::vector<std::string>* log = nullptr) : log_(log) {}
  Output<int> ticked{this, "ticked", "number of children ticked"};
  Status Tick(Children& children, bool) override {
    for (std::uint32_t k = 0; k < children.size(); ++k) {
      const Status result = children.Tick(k);
      ticked.Set(static_cast<int>(k + 1));
      if (result == Status::kRunning) children.HaltFrom(k + 1);
      if (result != Status::kSuccess && result != Status::kSkipped) return result;
    }
    return Status::kSuccess;
  }
  void OnHalted() override {
    if (log_) log_->push_back("halt parent");
  }

 private:
  std::vector<std::string>* log_;
};

class Throw : public UserDecorator {
 public:
  static constexpr const char* kDescription = "Throws when its child runs a second time.";
  Input<int> number{this, "number", "for the message"};
  Status Tick(Children& child, bool starting) override {
    const Status status = child.Tick(0);
    if (!starting) throw std::runtime_error("number " + std::to_string(*number));
    return status;
  }
};

class Comment : public UserDecorator {
 public:
  static constexpr const char* kDescription = "Says what its child returned.";
  Status Tick(Children& child, bool) override {
    const Status status = child.Tick(0);
    Say(ToString(status));
    return status;
  }
};

TEST(UserControl, TicksTheChildrenThatItWants) {
  LeafHarness harness = LeafHarness::WithChildren<Alternate>(2);
  harness.SetChild(0, {Status::kRunning, Status::kFailure});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.TakeChildEvents(), (Events{"start 0", "tick 0", "start 1"}));
}

TEST(UserControl, ItsResultMakesAllChildrenIdle) {
  LeafHarness harness = LeafHarness::WithChildren<Guarded>(2);
  harness.SetChild(1, {Status::kRunning, Status::kFailure});
  harness.Tick();
  EXPECT_EQ(harness.child_status(0), Status::kSuccess);
  EXPECT_EQ(harness.child_status(1), Status::kRunning);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.child_status(0), Status::kIdle);
  EXPECT_EQ(harness.child_status(1), Status::kIdle);
}

TEST(UserControl, ItsResultHaltsChildrenThatRun) {
  LeafHarness harness = LeafHarness::WithChildren<Guarded>(2);
  harness.SetChild(0, {Status::kSuccess, Status::kFailure});
  harness.SetChild(1, {Status::kRunning});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.TakeChildEvents(), (Events{"start 0", "start 1", "start 0", "halt 1"}));
}

TEST(UserControl, HaltsChildrenThatItNoLongerWants) {
  LeafHarness harness = LeafHarness::WithChildren<Guarded>(3);
  harness.SetChild(0, {Status::kSuccess, Status::kRunning});
  harness.SetChild(2, {Status::kRunning});
  harness.Tick();
  harness.TakeChildEvents();
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.TakeChildEvents(), (Events{"start 0", "halt 2"}));
  EXPECT_EQ(harness.child_status(2), Status::kIdle);
}

TEST(UserControl, ASkippedChildIsNoAffair) {
  LeafHarness harness = LeafHarness::WithChildren<Guarded>(2);
  harness.SetChild(0, {Status::kSkipped});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  LeafHarness skipped = LeafHarness::WithChildren<Alternate>(1);
  skipped.SetChild(0, {Status::kSkipped});
  EXPECT_EQ(skipped.Tick(), Status::kSkipped);
}

TEST(UserControl, IsToldOfTheHaltBeforeItsChildren) {
  Stage stage(Main("<AlwaysSuccess/>"));
  auto registry = std::make_shared<Registry>();
  registry->Register<Guarded>("Guarded", &stage.script.events);
  registry->SetFallback([&stage](const std::string& name) {
    return std::make_unique<ScriptedLeaf>(stage.script, name);
  });
  stage.script.results = {{"a", {Status::kRunning}}, {"b", {Status::kRunning}}};
  Diagnostics diagnostics;
  const auto program = CompileText(Main(R"(
      <Guarded>
        <Leaf name="c"/>
        <Parallel><Leaf name="a"/><Leaf name="b"/></Parallel>
      </Guarded>)"),
                                   diagnostics, registry);
  ASSERT_TRUE(program) << diagnostics.ToString();
  Executor executor(program, stage.clock);
  EXPECT_EQ(executor.Tick(), Status::kRunning);
  stage.TakeEvents();
  executor.Halt();
  EXPECT_EQ(stage.TakeEvents(), (Events{"halt parent", "halt a", "halt b"}));
}

TEST(UserControl, AnExceptionFailsItAndHaltsItsChildren) {
  LeafHarness harness = LeafHarness::WithChildren<Throw>(1);
  harness.Set("number", 5);
  harness.SetChild(0, {Status::kRunning});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "number 5");
  EXPECT_EQ(harness.TakeChildEvents(), (Events{"start 0", "tick 0", "halt 0"}));
}

TEST(UserControl, AnInputWithoutValueIsNamed) {
  LeafHarness harness = LeafHarness::WithChildren<Throw>(1);
  harness.SetChild(0, {Status::kRunning});
  harness.Tick();
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_NE(harness.message().find(R"("number")"), std::string::npos) << harness.message();
}

TEST(UserControl, WritesItsPorts) {
  LeafHarness harness = LeafHarness::WithChildren<Guarded>(3);
  harness.SetChild(1, {Status::kRunning});
  harness.Tick();
  EXPECT_EQ(harness.Get<int>("ticked"), 2);
}

TEST(UserControl, WhatItSaysAfterTickingAChildIsItsOwnMessage) {
  auto registry = std::make_shared<Registry>();
  registry->Register<Comment>("Comment");
  Diagnostics diagnostics;
  const auto program = CompileText(Main("<Comment><Comment><AlwaysFailure/></Comment></Comment>"),
                                   diagnostics, registry);
  ASSERT_TRUE(program) << diagnostics.ToString();
  SimulatedClock clock;
  KeepingSink sink;
  Executor executor(program, clock);
  executor.AddSink(&sink);
  executor.Tick();
  ASSERT_EQ(sink.ticks.at(0).messages.size(), 2U);
  EXPECT_EQ(sink.ticks[0].messages[0].node, 1U);
  EXPECT_EQ(sink.ticks[0].messages[1].node, 0U);
}

TEST(UserControl, NestsWithBuiltInNodes) {
  auto registry = std::make_shared<Registry>();
  registry->Register<Alternate>("Alternate");
  Diagnostics diagnostics;
  const auto program = CompileText(Main(R"(
      <Repeat num_cycles="4">
        <Alternate>
          <AlwaysSuccess/>
          <Control ID="Alternate">
            <AlwaysSuccess/>
            <ForceSuccess><AlwaysFailure/></ForceSuccess>
          </Control>
        </Alternate>
      </Repeat>)"),
                                   diagnostics, registry);
  ASSERT_TRUE(program) << diagnostics.ToString();
  SimulatedClock clock;
  Executor executor(program, clock);
  Status status = Status::kRunning;
  for (int i = 0; i < 10 && status == Status::kRunning; ++i) status = executor.Tick();
  EXPECT_EQ(status, Status::kSuccess);
  EXPECT_EQ(executor.ticks(), 4U);
}

TEST(UserControl, TheNumberOfChildrenIsChecked) {
  EXPECT_THROW(LeafHarness::WithChildren<Guarded>(1), std::invalid_argument);
  EXPECT_THROW(LeafHarness::WithChildren<Guarded>(4), std::invalid_argument);
  EXPECT_THROW(LeafHarness::WithChildren<Alternate>(0), std::invalid_argument);
  EXPECT_THROW(LeafHarness::WithChildren<Comment>(2), std::invalid_argument);
}

}  // namespace
}  // namespace coppice
