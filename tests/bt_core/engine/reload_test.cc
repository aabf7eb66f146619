// Swapping the program of a running executor.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using Names = std::vector<std::string>;
constexpr Status kIdle = Status::kIdle;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSkipped = Status::kSkipped;
constexpr Status kSuccess = Status::kSuccess;

// Runs until told otherwise; the answer comes through a mailbox.
struct Phone {
  Names events;
  Sender<int> answer;
};

class Call : public Action {
 public:
  static constexpr const char* kDescription = "Calls somebody and waits for the answer.";
  Input<std::string> who{this, "who", "name"};
  Output<int> heard{this, "heard", "the answer"};
  Mailbox<int> mailbox{this, "mailbox"};
  explicit Call(Phone* phone) : phone_(*phone) {}
  Status OnStart() override {
    phone_.events.push_back("call " + *who);
    phone_.answer = mailbox.NewSender();
    return kRunning;
  }
  Status OnRunning() override {
    const int* answer = mailbox.Take();
    if (!answer) return kRunning;
    heard.Set(*answer);
    phone_.events.push_back(*who + " said " + std::to_string(*answer));
    return kSuccess;
  }
  void OnHalted() override { phone_.events.push_back("hang up " + *who); }

 private:
  Phone& phone_;
};

class Reload : public ::testing::Test {
 protected:
  Reload() {
    auto registry = std::make_shared<Registry>(*TestRegistry());
    registry->Register<Call>("Call", &phone_);
    registry_ = registry;
  }
  std::shared_ptr<const Program> Load(const std::string& text) {
    Diagnostics diagnostics;
    auto program = CompileText(text, diagnostics, registry_);
    EXPECT_TRUE(program) << diagnostics.ToString();
    return program;
  }
  void Start(const std::string& body) {
    executor_ = std::make_unique<Executor>(Load(Main(body)), clock_);
    executor_->Tick();
  }
  Names Events() { return std::exchange(phone_.events, {}); }

  Phone phone_;
  SimulatedClock clock_;
  std::shared_ptr<const Registry> registry_;
  std::unique_ptr<Executor> executor_;
};

constexpr char kCallAnn[] = R"(<Call name="ann" who="Ann" heard="{a}"/>)";
constexpr char kCallBob[] = R"(<Call name="bob" who="Bob" heard="{b}"/>)";

std::string Sequence(const std::string& children) {
  return "<Sequence>" + children + "</Sequence>";
}

TEST_F(Reload, WhatIsWrittenTheSameGoesOnUndisturbed) {
  Start(Sequence(std::string("<AlwaysSuccess/>") + kCallAnn));
  const auto next = Load(Main(Sequence(std::string("<AlwaysFailure/>") + kCallAnn)));
  executor_->Reload(next);
  EXPECT_EQ(executor_->statuses(), (std::vector<Status>{kRunning, kIdle, kRunning}));
  executor_->Tick();
  EXPECT_EQ(Events(), (Names{"call Ann"}));
}

TEST_F(Reload, AnAnswerToAQuestionFromBeforeArrives) {
  Start(Sequence(std::string("<AlwaysSuccess/>") + kCallAnn));
  executor_->Reload(Load(
      Main(Sequence(R"(<Sequence><AlwaysSuccess/><Drive goal="{new}" total="{t}"/></Sequence>)" +
                    std::string(kCallAnn)))));
  phone_.answer.Send(7);
  EXPECT_EQ(executor_->Tick(), kSuccess);
  EXPECT_EQ(Events(), (Names{"call Ann", "Ann said 7"}));
  const SlotIndex slot = executor_->program().layout.Find(kMainScope, "a");
  EXPECT_EQ(executor_->blackboard()[slot].value.Get<int>(), 7);
}

TEST_F(Reload, TheSequenceStaysAtItsChildThoughTheNumbersOfNodesChange) {
  Start(Sequence(std::string("<AlwaysSuccess/>") + kCallAnn));
  executor_->Reload(
      Load(Main(Sequence("<Inverter><AlwaysFailure/></Inverter>" + std::string(kCallAnn)))));
  EXPECT_EQ(executor_->Tick(), kRunning);
  EXPECT_EQ(executor_->statuses()[3], kRunning);
  EXPECT_EQ(Events(), (Names{"call Ann"}));
}

TEST_F(Reload, WhatIsWrittenOtherwiseIsHaltedAndBeginsAnew) {
  Start(Sequence(std::string("<AlwaysSuccess/>") + kCallAnn));
  executor_->Reload(Load(Main(Sequence(std::string("<AlwaysSuccess/>") + kCallBob))));
  EXPECT_EQ(Events(), (Names{"call Ann", "hang up Ann"}));
  EXPECT_EQ(executor_->Tick(), kRunning);
  EXPECT_EQ(Events(), (Names{"call Bob"}));
}

TEST_F(Reload, AsksForATickIfTheTreeRuns) {
  Start(Sequence(kCallAnn));
  EXPECT_EQ(executor_->next_tick(), kNever);
  executor_->Reload(Load(Main(Sequence(kCallBob))));
  EXPECT_EQ(executor_->next_tick(), Time{});
}

TEST_F(Reload, AnAnswerToAHaltedNodeIsDropped) {
  Start(kCallAnn);
  executor_->Reload(Load(Main(kCallBob)));
  const Sender<int> old = phone_.answer;
  executor_->Tick();
  old.Send(3);
  EXPECT_EQ(executor_->Tick(), kRunning);
}

TEST_F(Reload, KeepsTheBlackboard) {
  Start(Sequence(std::string(R"(<Drive goal="2" total="{total}"/>)") + kCallAnn));
  executor_->Reload(
      Load(Main(Sequence(std::string(kCallBob) + R"(<Drive goal="3" total="{total}"/>)"
                                                 R"(<Drive goal="3" total="{other}"/>)"))));
  const Program& program = executor_->program();
  EXPECT_EQ(executor_->blackboard()[program.layout.Find(kMainScope, "total")].value.Get<int>(), 3);
  EXPECT_FALSE(executor_->blackboard()[program.layout.Find(kMainScope, "other")].value.has_value());
}

TEST_F(Reload, SendersStayValid) {
  Start(R"(<Drive goal="{way}" total="{total}"/>)");
  const Sender<double> way = executor_->Writer<double>("way");
  executor_->Reload(Load(
      Main(Sequence(R"(<Drive goal="1" total="{x}"/><Drive goal="{way}" total="{total}"/>)"))));
  executor_->Reload(Load(Main(R"(<Drive goal="{way}" total="{total}"/>)")));
  way.Send(4.5);
  executor_->Tick();
  const SlotIndex slot = executor_->program().layout.Find(kMainScope, "way");
  EXPECT_EQ(executor_->blackboard()[slot].value.Get<double>(), 4.5);
}

TEST_F(Reload, ASenderOfAKeyThatIsGoneDrops) {
  Start(R"(<Drive goal="{way}" total="{total}"/>)");
  const Sender<double> way = executor_->Writer<double>("way");
  executor_->Reload(Load(Main("<AlwaysSuccess/>")));
  way.Send(4.5);
  EXPECT_EQ(executor_->Tick(), kSuccess);
}

TEST_F(Reload, ANodeWithMoreChildrenBeginsAnew) {
  Start(Sequence(kCallAnn));
  executor_->Reload(Load(Main(Sequence(std::string(kCallAnn) + kCallBob))));
  EXPECT_EQ(Events(), (Names{"call Ann", "hang up Ann"}));
}

TEST_F(Reload, ASubTreeIsSwappedAloneWithTheRestRunning) {
  const std::string main = R"(<BehaviorTree ID="Main"><Parallel failure_count="2">)" +
                           std::string(kCallAnn) +
                           R"(<SubTree ID="Part" name="part"/></Parallel></BehaviorTree>)";
  const auto part = [](const std::string& body) {
    return R"(<BehaviorTree ID="Part">)" + body + "</BehaviorTree>";
  };
  executor_ = std::make_unique<Executor>(Load(Root(main + part(kCallBob))), clock_);
  executor_->Tick();
  Events();
  executor_->Reload(Load(Root(main + part(R"(<Call name="eve" who="Eve" heard="{b}"/>)"))));
  EXPECT_EQ(executor_->Tick(), kRunning);
  EXPECT_EQ(Events(), (Names{"hang up Bob", "call Eve"}));
}

TEST_F(Reload, SinksAreTold) {
  struct Following : KeepingSink {
    void OnJump(const Executor& executor) override {
      nodes = executor.program().nodes.size();
      halts = ticks.size();
    }
    std::size_t nodes = 0;
    std::size_t halts = 0;
  };
  Start(kCallAnn);
  Following sink;
  executor_->AddSink(&sink);
  executor_->Reload(Load(Main(Sequence(kCallBob))));
  EXPECT_EQ(sink.nodes, 2U);
  EXPECT_EQ(sink.halts, 1U);
  EXPECT_EQ(executor_->Tick(), kRunning);
  executor_->RemoveSink(&sink);
}

class Skipping : public ::testing::Test {
 protected:
  void Load(const std::string& body) {
    auto registry = std::make_shared<Registry>();
    registry->SetFallback(
        [this](const std::string& name) { return std::make_unique<ScriptedLeaf>(script_, name); });
    Diagnostics diagnostics;
    program_ = CompileText(Main(body), diagnostics, registry);
    ASSERT_TRUE(program_) << diagnostics.ToString();
    if (executor_) return executor_->Reload(program_);
    executor_ = std::make_unique<Executor>(program_, clock_);
  }
  // Twice: so the leaf "a" has begun and is skipped.
  void SkipA() {
    script_.results["a"] = {kRunning, kSkipped, kRunning};
    executor_->Tick();
    executor_->Tick();
    EXPECT_EQ(Events(), (Names{"start a", "tick a"}));
  }
  Names Events() { return std::exchange(script_.events, {}); }

  LeafScript script_;
  SimulatedClock clock_;
  std::shared_ptr<const Program> program_;
  std::unique_ptr<Executor> executor_;
};

TEST_F(Skipping, ALeafThatLivesOnGoesOnWithWhatItHasBegun) {
  const std::string until_failure =
      R"(<KeepRunningUntilFailure><Inverter><Leaf name="a"/></Inverter></KeepRunningUntilFailure>)";
  Load(Sequence("<AlwaysSuccess/>" + until_failure));
  SkipA();
  Load(Sequence("<Inverter><AlwaysFailure/></Inverter>" + until_failure));  // other numbers
  EXPECT_EQ(Events(), Names{});
  executor_->Tick();
  EXPECT_EQ(Events(), (Names{"tick a"}));
}

TEST_F(Skipping, ALeafThatLivesOnIsHaltedWithItsParent) {
  Load(R"(<ForceSuccess><Inverter><Leaf name="a"/></Inverter></ForceSuccess>)");
  SkipA();
  Load(R"(<ForceSuccess><Inverter><Leaf name="a"/></Inverter></ForceSuccess>)");
  executor_->Halt();
  EXPECT_EQ(Events(), (Names{"halt a"}));
}

TEST_F(Skipping, ALeafThatEndsIsHalted) {
  Load(R"(<Inverter><Leaf name="a"/></Inverter>)");
  SkipA();
  Load(R"(<Inverter><Leaf name="b"/></Inverter>)");
  EXPECT_EQ(Events(), (Names{"halt a"}));
  executor_->Tick();
  EXPECT_EQ(Events(), (Names{"start b"}));
}

TEST_F(Skipping, ALeafEndsWithItsParent) {
  Load(R"(<Inverter><Leaf name="a"/></Inverter>)");
  SkipA();
  Load(R"(<ForceFailure><Leaf name="a"/></ForceFailure>)");
  EXPECT_EQ(Events(), (Names{"halt a"}));
  executor_->Tick();
  EXPECT_EQ(Events(), (Names{"start a"}));
}

TEST_F(Skipping, ALoopThatLivesOnKeepsItsRounds) {
  script_.results["a"] = {kSuccess, kSkipped, kSuccess};
  const std::string loop = R"(<Repeat num_cycles="2"><Leaf name="a"/></Repeat>)";
  Load(loop);
  EXPECT_EQ(executor_->Tick(), kRunning);
  EXPECT_EQ(executor_->Tick(), kSkipped);
  Load(loop);
  EXPECT_EQ(executor_->Tick(), kSuccess);
}

TEST_F(Skipping, ALoopThatIsWrittenOtherwiseBeginsAnew) {
  script_.results["a"] = {kSuccess, kSkipped, kSuccess};
  Load(R"(<Repeat num_cycles="2"><Leaf name="a"/></Repeat>)");
  EXPECT_EQ(executor_->Tick(), kRunning);
  EXPECT_EQ(executor_->Tick(), kSkipped);
  Load(R"(<Repeat num_cycles="2" name="again"><Leaf name="a"/></Repeat>)");
  EXPECT_EQ(executor_->Tick(), kRunning);
}

}  // namespace
}  // namespace coppice
