// Random trees of all node types with random leaves: recorded and verified.
#include <gtest/gtest.h>

#include <random>

#include "bt_core/analysis/play/verify.h"
#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int Uniform(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  bool OneIn(int n) { return Uniform(1, n) == 1; }
  std::string Pick(const std::vector<std::string>& all) {
    return all[static_cast<std::size_t>(Uniform(0, static_cast<int>(all.size()) - 1))];
  }

 private:
  std::mt19937 random_;
};

// Does what the dice say: results, writes, messages, exceptions.
class RandomLeaf final : public Leaf {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kAction;
  static constexpr const char* kDescription = "Whatever.";
  explicit RandomLeaf(Dice* dice) : dice_(*dice) {}

  InOut<std::string> word{this, "word", "sometimes written"};
  Output<int> number{this, "number", "sometimes written"};

  Status Tick(bool) override {
    if (dice_.OneIn(4)) word.Set(dice_.Pick({"a", "b", "c"}));
    if (dice_.OneIn(4)) number.Set(dice_.Uniform(0, 3));
    if (dice_.OneIn(4)) Say("says " + std::to_string(dice_.Uniform(1, 9)));
    if (dice_.OneIn(20)) throw std::runtime_error("throws");
    return static_cast<Status>(dice_.Uniform(1, 4));
  }
  void Halt() override {
    if (dice_.OneIn(3)) Say("stops");
  }

 private:
  Dice& dice_;
};

class RandomControl final : public UserControl {
 public:
  static constexpr const char* kDescription = "Whatever.";
  explicit RandomControl(Dice* dice) : dice_(*dice) {}

  Output<std::string> word{this, "word", "sometimes written"};

  Status Tick(Children& children, bool) override {
    Status status = Status::kSuccess;
    for (int i = dice_.Uniform(0, 3); i > 0; --i) {
      const auto k =
          static_cast<std::uint32_t>(dice_.Uniform(0, static_cast<int>(children.size()) - 1));
      if (dice_.OneIn(4)) word.Set(dice_.Pick({"a", "b", "c"}));
      if (dice_.OneIn(3)) children.Halt(k);
      if (dice_.OneIn(5)) Say("between");
      if (dice_.OneIn(5)) children.HaltFrom(k);
      status = children.Tick(k);
    }
    return dice_.OneIn(2) ? status : static_cast<Status>(dice_.Uniform(1, 4));
  }
  void OnHalted() override {
    if (dice_.OneIn(3)) Say("stops");
  }

 private:
  Dice& dice_;
};

struct Kind {
  const char* type;
  int min_children;
  int max_children;
  std::vector<std::pair<const char*, std::vector<std::string>>> ports = {};
};

const std::vector<std::string> kKeys = {"{@k}", "{@j}"};

const std::vector<Kind> kKinds = {
    {"Sequence", 1, 4},
    {"Fallback", 1, 4},
    {"ReactiveSequence", 1, 4},
    {"ReactiveFallback", 1, 4},
    {"AsyncSequence", 1, 4},
    {"AsyncFallback", 1, 4},
    {"SequenceWithMemory", 1, 4},
    {"PersistentSequence", 1, 4, {{"current_child_idx", {"{@m}", "{@n}"}}}},
    {"Parallel", 2, 4, {{"success_count", {"-1", "1", "2"}}, {"failure_count", {"1", "2"}}}},
    {"ParallelAll", 1, 4, {{"max_failures", {"1", "-1"}}}},
    {"WorstOf", 1, 4},
    {"PipelineSequence", 1, 4},
    {"NonblockingSequence", 1, 4},
    {"IfThenElse", 2, 3},
    {"WhileDoElse", 2, 3},
    {"TryCatch", 2, 4, {{"catch_on_halt", {"true", "false"}}}},
    {"RecoveryNode", 2, 2, {{"number_of_retries", {"0", "1", "2"}}}},
    {"RoundRobin", 1, 4, {{"wrap_around", {"true", "false"}}}},
    {"RandomSequence", 1, 4, {{"seed", {"1", "2"}}}},
    {"RandomSelector", 1, 4, {{"seed", {"1", "2"}}}},
    {"Switch2", 3, 3, {{"variable", kKeys}, {"case_1", {"a"}}, {"case_2", {"b"}}}},
    {"Switch", 4, 4, {{"variable", kKeys}, {"cases", {"a;b;c", "c;a;a"}}}},
    {"RandomControl", 1, 4, {{"word", kKeys}}},
    {"RandomControl", 1, 4, {{"word", kKeys}}},
    {"Inverter", 1, 1},
    {"ForceSuccess", 1, 1},
    {"ForceFailure", 1, 1},
    {"Repeat", 1, 1, {{"num_cycles", {"-1", "1", "2", "3"}}}},
    {"RetryUntilSuccessful", 1, 1, {{"num_attempts", {"-1", "1", "2", "3"}}}},
    {"KeepRunningUntilFailure", 1, 1},
    {"Timeout", 1, 1, {{"msec", {"0", "70", "140"}}}},
    {"Delay", 1, 1, {{"delay_msec", {"0", "70", "140"}}}},
    {"RunOnce", 1, 1, {{"then_skip", {"true", "false"}}}},
    {"SingleTrigger", 1, 1},
    {"RateController", 1, 1, {{"hz", {"1", "5", "20"}}}},
    {"Cooldown",
     1,
     1,
     {{"msec", {"70", "140"}}, {"if_cooling", {"SUCCESS", "RUNNING", "SKIPPED"}}}},
    {"CircuitBreaker", 1, 1, {{"max_failures", {"1", "2"}}, {"open_msec", {"70", "140"}}}},
    {"SkipUnlessUpdated", 1, 1, {{"entry", kKeys}}},
    {"WaitValueUpdate", 1, 1, {{"entry", kKeys}}},
    {"Precondition", 1, 1, {{"if", {"@k == 'a'", "@j == 'b'"}}, {"else", {"SUCCESS", "SKIPPED"}}}},
    {"LoopString", 1, 1, {{"queue", {"", "a", "b;a;c"}}, {"value", kKeys}}},
    {"LoopInt", 1, 1, {{"queue", {"1;2"}}}},
    {"Consecutive", 1, 1, {{"successes", {"1", "2"}}, {"failures", {"1", "3"}}}},
    {"Debounce", 1, 1, {{"success_msec", {"0", "70"}}, {"failure_msec", {"0", "140"}}}},
};

const std::vector<Kind> kLeaves = {
    {"AlwaysSuccess", 0, 0},
    {"AlwaysFailure", 0, 0},
    {"Sleep", 0, 0, {{"msec", {"0", "70", "140"}}}},
    {"WasEntryUpdated", 0, 0, {{"entry", kKeys}}},
    {"SetBlackboard", 0, 0, {{"value", {"a", "b", "{@k}"}}, {"output_key", kKeys}}},
    {"UnsetBlackboard", 0, 0, {{"key", kKeys}}},
    {"Script", 0, 0, {{"code", {"@k := 'b'", "@j := 'a'; x := 1", "x += 1"}}}},
    {"ScriptCondition", 0, 0, {{"code", {"@k == 'b'", "@j == 'a'", "number > 1"}}}},
    {"Hysteresis", 0, 0, {{"value", {"{level}"}}, {"low", {"1"}}, {"high", {"2"}}}},
    {"TestNode", 0, 0, {{"return_status", {"SUCCESS", "FAILURE"}}, {"async_delay", {"0", "70"}}}},
};

const std::vector<std::string> kGuards = {
    R"(_skipIf="@k == 'a'")",    R"(_failureIf="@j == 'c'")",
    R"(_successIf="@k == 'c'")", R"(_onlyIf="@k != 'b'")",
    R"(_while="@j != 'b'")",     R"(_onStart="starts += 1")",
    R"(_onHalted="@k := 'b'")",  R"(_post="@j := 'c'")",
    R"(_onSuccess="@j := 'a'")", R"(_onFailure="fails += 1")",
    R"(_onStart="@k := 'a'")",   R"(_while="@k != 'c'" _skipIf="@j == 'a'")"};

class Generator {
 public:
  explicit Generator(Dice& dice) : dice_(dice) {}

  std::string Tree() {
    return R"(<BehaviorTree ID="Main">)" + Node(4) + R"(</BehaviorTree><BehaviorTree ID="Sub">)" +
           Node(2) + "</BehaviorTree>";
  }

 private:
  std::string Node(int depth) {
    if (depth == 0 || dice_.OneIn(10)) return LeafNode();
    if (depth > 2 && dice_.OneIn(15)) return R"(<SubTree ID="Sub")" + Guards() + "/>";
    const Kind& kind =
        kKinds[static_cast<std::size_t>(dice_.Uniform(0, static_cast<int>(kKinds.size()) - 1))];
    std::string xml = Begin(kind) + ">";
    for (int i = dice_.Uniform(kind.min_children, kind.max_children); i > 0; --i) {
      xml += Node(depth - 1);
    }
    return xml + "</" + kind.type + ">";
  }

  std::string LeafNode() {
    if (dice_.Uniform(0, 9) < 7) {
      return "<RandomLeaf word=\"" + dice_.Pick(kKeys) + R"(" number="{number}")" + Guards() + "/>";
    }
    return Begin(kLeaves[static_cast<std::size_t>(
               dice_.Uniform(0, static_cast<int>(kLeaves.size()) - 1))]) +
           "/>";
  }

  std::string Begin(const Kind& kind) {
    std::string xml = std::string("<") + kind.type;
    for (const auto& [name, values] : kind.ports) {
      xml += std::string(" ") + name + "=\"" + dice_.Pick(values) + "\"";
    }
    return xml + Guards();
  }

  std::string Guards() { return dice_.OneIn(5) ? " " + dice_.Pick(kGuards) : ""; }

  Dice& dice_;
};

class RandomHooks final : public NodeHooks {
 public:
  explicit RandomHooks(Dice& dice) : dice_(dice) {}
  std::optional<Status> Before(NodeIndex) override { return Choose(); }
  std::optional<Status> After(NodeIndex, Status) override { return Choose(); }

 private:
  std::optional<Status> Choose() {
    if (!dice_.OneIn(4)) return std::nullopt;
    return static_cast<Status>(dice_.Uniform(1, 4));
  }
  Dice& dice_;
};

// What happens around the tree.
void RunAtRandom(RecordedRun& run, Dice& dice, RandomHooks& hooks, bool injects) {
  const Sender<std::string> word = run.executor.Writer<std::string>("k");
  const Sender<double> level = run.executor.Writer<double>("level");
  const int nodes = static_cast<int>(run.program->nodes.size());
  for (int tick = 0; tick < 30; ++tick) {
    if (dice.OneIn(6)) word.Send(dice.Pick({"a", "b", "c"}));
    if (dice.OneIn(6)) level.Send(dice.Uniform(0, 3));
    if (injects && dice.OneIn(5)) {
      run.executor.SetHooks(&hooks, {static_cast<NodeIndex>(dice.Uniform(0, nodes - 1)),
                                     static_cast<NodeIndex>(dice.Uniform(0, nodes - 1))});
    }
    run.Tick(std::chrono::milliseconds(dice.Uniform(0, 100)));
    if (dice.OneIn(10)) run.executor.Halt();
  }
  run.executor.SetHooks(nullptr, {});
}

void VerifyRandomTrees(bool injects) {
  constexpr unsigned kTrees = 2000;
  for (unsigned seed = 1; seed <= kTrees; ++seed) {
    Dice dice(seed);
    auto registry = std::make_shared<Registry>();
    registry->Register<RandomLeaf>("RandomLeaf", &dice);
    registry->Register<RandomControl>("RandomControl", &dice);
    const std::string xml = Generator(dice).Tree();
    RandomHooks hooks(dice);
    RecordedRun run(xml, registry);
    RunAtRandom(run, dice, hooks, injects);
    Diagnostics diagnostics;
    const Verification verification = Verify(run.keeper.run, {}, diagnostics);
    ASSERT_TRUE(verification.is_the_same())
        << "seed " << seed << ": " << PrintVerification(verification, run.keeper.run.start())
        << diagnostics.ToString() << xml;
    ASSERT_EQ(verification.skipped_ticks, 0u);
  }
}

TEST(RandomRuns, AreTheSameWhenTheyArePlayedAgain) { VerifyRandomTrees(false); }

TEST(RandomRuns, AreTheSameWithInjectedResults) { VerifyRandomTrees(true); }

}  // namespace
}  // namespace coppice
