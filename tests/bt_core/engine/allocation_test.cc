// A steady tick allocates nothing, and a loaded tree holds little.
#include <gtest/gtest.h>

#include "tests/bt_core/counting_new.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

// Passes a text on and never ends, changing its length with every tick.
class Chatter : public Action {
 public:
  static constexpr const char* kDescription = "Writes texts of up to 200 characters.";
  Input<std::string> text{this, "text", "what"};
  Output<std::string> copy{this, "copy", "the same"};
  Output<double> number{this, "number", "ticks so far"};
  Status OnStart() override { return OnRunning(); }
  Status OnRunning() override {
    const char* const texts[] = {"short", kLong};
    copy.Set(*text);
    number.Set(number_ += 1);
    buffer_.assign(texts[static_cast<int>(number_) % 2]);
    copy.Set(buffer_);
    WakeAt(now() + std::chrono::seconds(1));
    return Status::kRunning;
  }
  void OnHalted() override {}

 private:
  static constexpr const char* kLong =
      "0123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890"
      "123456789012345678901234567890123456789012345678901234567890123456789012345678901234567890"
      "1234567890123456789";
  double number_ = 0;
  std::string buffer_;
};

class IsPositive : public Condition {
 public:
  static constexpr const char* kDescription = "Is the number positive?";
  Input<double> number{this, "number", "which"};
  bool Check() override { return *number > 0; }
};

class Nod : public SyncAction {
 public:
  static constexpr const char* kDescription = "Succeeds.";
  Status Run() override { return Status::kSuccess; }
};

class CountingSink : public TickSink {
 public:
  void OnTick(const TickEvents& events) override { words += events.words.size; }
  std::size_t words = 0;
};

// All node types; the reactive ones make leaves start and end in every tick.
constexpr const char* kTree = R"(
<root BTCPP_format="4" main_tree_to_execute="Main">
 <BehaviorTree ID="Main">
  <Parallel success_count="-1" failure_count="-1">
   <ReactiveFallback>
    <Inverter><ForceSuccess><AlwaysFailure/></ForceSuccess></Inverter>
    <ForceFailure><AlwaysSuccess/></ForceFailure>
    <Sequence><IsPositive number="-1"/><AlwaysSuccess/></Sequence>
    <Timeout msec="3600000"><SubTree ID="Talk" words="{words}" out="{heard}"/></Timeout>
   </ReactiveFallback>
   <ReactiveSequence>
    <Fallback><AlwaysFailure/><IsPositive number="2.5"/></Fallback>
    <Delay delay_msec="0"><AlwaysSuccess/></Delay>
    <Repeat num_cycles="-1"><AlwaysSuccess/></Repeat>
   </ReactiveSequence>
   <RetryUntilSuccessful num_attempts="-1"><AlwaysFailure/></RetryUntilSuccessful>
   <Delay delay_msec="3600000"><AlwaysSuccess/></Delay>
   <KeepRunningUntilFailure>
    <ForceSuccess><SubTree ID="Others"/></ForceSuccess>
   </KeepRunningUntilFailure>
  </Parallel>
 </BehaviorTree>
 <BehaviorTree ID="Others">
  <ParallelAll max_failures="-1">
   <AsyncSequence><AlwaysSuccess/><AlwaysSuccess/></AsyncSequence>
   <AsyncFallback><AlwaysFailure/><AlwaysFailure/></AsyncFallback>
   <SequenceWithMemory><AlwaysSuccess/><AlwaysFailure/></SequenceWithMemory>
   <PersistentSequence current_child_idx="{place}"><AlwaysSuccess/></PersistentSequence>
   <WorstOf>
    <PipelineSequence><AlwaysSuccess/></PipelineSequence>
    <NonblockingSequence><AlwaysSuccess/></NonblockingSequence>
   </WorstOf>
   <IfThenElse><AlwaysSuccess/><AlwaysSuccess/></IfThenElse>
   <WhileDoElse><AlwaysSuccess/><AlwaysSuccess/></WhileDoElse>
   <Switch2 variable="{place}" case_1="1" case_2="0">
    <AlwaysFailure/><AlwaysSuccess/><AlwaysFailure/>
   </Switch2>
   <Switch variable="{place}" cases="red;green;0">
    <AlwaysFailure/><AlwaysFailure/><AlwaysSuccess/><AlwaysFailure/>
   </Switch>
   <TryCatch><AlwaysFailure/><AlwaysSuccess/></TryCatch>
   <RecoveryNode><AlwaysFailure/><AlwaysSuccess/></RecoveryNode>
   <RoundRobin><AlwaysFailure/><AlwaysSuccess/></RoundRobin>
   <RandomSequence><AlwaysSuccess/><AlwaysSuccess/></RandomSequence>
   <RandomSelector><AlwaysFailure/><AlwaysSuccess/></RandomSelector>
   <LoopInt queue="1;2" value="{int}"><AlwaysFailure/></LoopInt>
   <LoopBool queue="0;1" value="{bool}"><AlwaysFailure/></LoopBool>
   <LoopDouble queue="0.5;1" value="{double}"><AlwaysSuccess/></LoopDouble>
   <LoopString queue="a;b" value="{string}"><AlwaysFailure/></LoopString>
   <RunOnce><AlwaysSuccess/></RunOnce>
   <SingleTrigger><AlwaysSuccess/></SingleTrigger>
   <RateController hz="50"><AlwaysSuccess/></RateController>
   <Cooldown msec="15"><AlwaysSuccess/></Cooldown>
   <CircuitBreaker max_failures="3" open_msec="15"><AlwaysFailure/></CircuitBreaker>
   <Consecutive><AlwaysSuccess/></Consecutive>
   <Debounce><AlwaysSuccess/></Debounce>
   <Precondition if="place == 0"><AlwaysSuccess/></Precondition>
   <SkipUnlessUpdated entry="{int}"><AlwaysSuccess/></SkipUnlessUpdated>
   <WaitValueUpdate entry="{int}"><AlwaysSuccess/></WaitValueUpdate>
   <Sleep msec="15"/>
   <Script code="count := 1"/>
   <ScriptCondition code="count == 1"/>
   <SetBlackboard value="5" output_key="five"/>
   <UnsetBlackboard key="five"/>
   <WasEntryUpdated entry="{five}"/>
   <Hysteresis value="{double}" low="0" high="1"/>
   <TestNode/>
  </ParallelAll>
 </BehaviorTree>
 <BehaviorTree ID="Talk">
  <ReactiveSequence>
   <Chatter text="{words}" copy="{out}" number="{n}"/>
  </ReactiveSequence>
 </BehaviorTree>
</root>)";

class AllocationTest : public testing::Test {
 protected:
  AllocationTest() {
    auto registry = std::make_shared<Registry>();
    registry->Register<Chatter>("Chatter");
    registry->Register<IsPositive>("IsPositive");
    Diagnostics diagnostics;
    program_ = CompileText(kTree, diagnostics, registry);
    if (!program_) throw std::logic_error(diagnostics.ToString());
    executor_ = std::make_unique<Executor>(program_, clock_);
    executor_->Writer<std::string>("words").Send(std::string(200, 'w'));
  }

  // Allocations of 1000 ticks after the first few.
  std::size_t SteadyTicks() {
    const auto tick = [this] {
      clock_.Advance(std::chrono::milliseconds(10));
      return executor_->Tick();
    };
    for (int i = 0; i < 10; ++i) EXPECT_EQ(tick(), Status::kRunning);
    const std::size_t before = Allocations();
    for (int i = 0; i < 1000; ++i) tick();
    return Allocations() - before;
  }

  std::shared_ptr<const Program> program_;
  SimulatedClock clock_;
  std::unique_ptr<Executor> executor_;
};

// A tree of so many levels, each node of which but the leaves has four children.
std::string FullTree(int levels, const std::string& indent = "\n") {
  if (levels == 1) return indent + "<Nod/>";
  std::string text = indent + "<Sequence>";
  for (int i = 0; i < 4; ++i) text += FullTree(levels - 1, indent + "  ");
  return text + indent + "</Sequence>";
}

TEST(Memory, OfALoadedTreeIsAtMostAHundredBytesPerNode) {
  Diagnostics diagnostics;
  const std::string text = Root("<BehaviorTree ID=\"Main\">" + FullTree(8) + "</BehaviorTree>");
  const auto registry = std::make_shared<Registry>();
  registry->Register<Nod>("Nod");
  SimulatedClock clock;
  const std::int64_t before = BytesHeld();
  const Executor executor(CompileText(text, diagnostics, registry), clock);
  const auto nodes = static_cast<std::int64_t>(executor.program().nodes.size());
  EXPECT_LE((BytesHeld() - before) / nodes, 100) << nodes << " nodes";
}

TEST(Allocations, AreCounted) {
  const std::size_t before = Allocations();
  const auto number = std::make_unique<int>(5);
  EXPECT_EQ(Allocations(), before + 1) << *number;
}

TEST_F(AllocationTest, TheTreeHasAllNodeTypes) {
  std::vector<bool> seen(static_cast<std::size_t>(NodeType::kLeaf) + 1);
  for (const NodeRecord& node : program_->nodes) seen[static_cast<std::size_t>(node.type)] = true;
  for (std::size_t type = 0; type < seen.size(); ++type) EXPECT_TRUE(seen[type]) << type;
}

TEST_F(AllocationTest, ASteadyTickAllocatesNothing) { EXPECT_EQ(SteadyTicks(), 0U); }

TEST_F(AllocationTest, ASteadyTickWithASinkAllocatesNothing) {
  CountingSink sink;
  executor_->AddSink(&sink);
  EXPECT_EQ(SteadyTicks(), 0U);
  EXPECT_GT(sink.words, 1000U);
  executor_->RemoveSink(&sink);
}

}  // namespace
}  // namespace coppice
