// Random trees of all node types with random guards and hooks, run for some dozen ticks with random
// results, halts, time and writes from outside.
#include <gtest/gtest.h>

#include <random>

#include "tests/conformance/side_by_side.h"

namespace coppice::conformance {
namespace {

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  int Uniform(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

  Shape Tree(int depth) {
    if (depth == 0 || Uniform(0, 9) == 0) return LeafOfTree();
    const NodeKind& kind = Pick(Uniform(0, 1) == 0 ? kControls : kDecorators);
    Shape shape{kind.type, {}, {}};
    const int children = Uniform(kind.min_children, kind.max_children);
    for (const PortKind& port : kind.ports) {
      if (Uniform(0, 3) == 0 && !port.required) continue;
      shape.attributes.emplace_back(port.name, Value(port, children));
    }
    AddScripts(shape);
    for (int i = 0; i < children; ++i) shape.children.push_back(Tree(depth - 1));
    return shape;
  }

 private:
  // The values of a port: texts, or numbers from .. to, times the factor.
  struct PortKind {
    const char* name;
    bool required;
    int from;
    int to;
    int factor = 1;
    std::vector<const char*> texts = {};
  };
  struct NodeKind {
    const char* type;
    int min_children;
    int max_children;
    std::vector<PortKind> ports = {};
  };
  static constexpr int kChildren = 99;  // stands for the number of children

  static const PortKind kVariable;
  static const PortKind kEntry;
  static const PortKind kMeasured;
  static const std::vector<NodeKind> kControls;
  static const std::vector<NodeKind> kDecorators;
  static const std::vector<NodeKind> kLeaves;

  template <class T>
  const T& Pick(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(Uniform(0, static_cast<int>(all.size()) - 1))];
  }

  Shape LeafOfTree() {
    Shape shape{"Leaf", {}, {}};
    if (Uniform(0, 9) >= 7) {
      const NodeKind& kind = Pick(kLeaves);
      shape.type = kind.type;
      for (const PortKind& port : kind.ports)
        shape.attributes.emplace_back(port.name, Value(port, 0));
    }
    AddScripts(shape);
    return shape;
  }

  // Guards ask a key that is written from outside; each hook writes a character of its own.
  void AddScripts(Shape& shape) {
    for (const char* hook : {"_onStart", "_onSuccess", "_onFailure", "_post", "_onHalted"}) {
      if (Uniform(0, 7) != 0) continue;
      const char name = static_cast<char>('A' + next_hook_++ % 26);
      shape.attributes.emplace_back(hook, std::string("@hooks += '") + name + "'");
    }
    if (Uniform(0, 3) != 0) return;
    const NodeScript& guard = Pick(kGuards);
    shape.attributes.emplace_back(guard.first, guard.second);
  }

  std::string Value(const PortKind& port, int children) {
    if (!port.texts.empty()) return Pick(port.texts);
    const int from = port.from == -kChildren ? -children - 1 : port.from;
    const int to = port.to == kChildren ? children : port.to;
    return std::to_string(Uniform(from, to) * port.factor);
  }

  using NodeScript = std::pair<const char*, const char*>;
  static const std::vector<NodeScript> kGuards;

  std::mt19937 random_;
  int next_hook_ = 0;
};

const std::vector<Generator::NodeScript> Generator::kGuards = {
    {"_failureIf", "@g == 1"}, {"_successIf", "@g == 2"}, {"_skipIf", "@g == 3"},
    {"_onlyIf", "@g != 4"},    {"_while", "@g != 5"},
};

// Keys of the main tree, so that all SubTrees share them.
const Generator::PortKind Generator::kVariable = {"variable", true, 0, 0, 1, {"{@k}", "{@j}"}};
const Generator::PortKind Generator::kEntry = {"entry", true, 0, 0, 1, {"{@k}", "{@j}"}};
const Generator::PortKind Generator::kMeasured = {"value", true, 0, 0, 1, {"{@x}", "{@y}"}};

const std::vector<Generator::NodeKind> Generator::kControls = {
    {"Sequence", 1, 4},
    {"Fallback", 1, 4},
    {"ReactiveSequence", 1, 4},
    {"ReactiveFallback", 1, 4},
    {"AsyncSequence", 1, 4},
    {"AsyncFallback", 1, 4},
    {"SequenceWithMemory", 1, 4},
    {"Parallel",
     1,
     4,
     {{"success_count", false, -kChildren, kChildren},
      {"failure_count", false, -kChildren, kChildren}}},
    {"ParallelAll", 1, 4, {{"max_failures", false, -kChildren, kChildren}}},
    {"WorstOf", 1, 4},
    {"PipelineSequence", 1, 4},
    {"NonblockingSequence", 1, 4},
    {"IfThenElse", 2, 3},
    {"WhileDoElse", 2, 3},
    {"TryCatch", 2, 4, {{"catch_on_halt", false, 0, 0, 1, {"true", "false"}}}},
    {"RecoveryNode", 2, 2, {{"number_of_retries", false, -1, 3}}},
    {"RoundRobin", 1, 4, {{"wrap_around", false, 0, 0, 1, {"true", "false"}}}},
    {"RandomSequence", 1, 4, {{"seed", false, 0, 3}}},
    {"RandomSelector", 1, 4, {{"seed", false, 0, 3}}},
    {"PersistentSequence", 1, 4, {{"current_child_idx", true, 0, 0, 1, {"{@m}", "{@n}"}}}},
    {"Switch2",
     3,
     3,
     {kVariable, {"case_1", false, 0, 0, 1, {"a"}}, {"case_2", true, 0, 0, 1, {"b"}}}},
    {"Switch", 4, 4, {kVariable, {"cases", true, 0, 0, 1, {"a;b;c", "c;a;a"}}}},
};

const std::vector<Generator::NodeKind> Generator::kDecorators = {
    {"Inverter", 1, 1},
    {"ForceSuccess", 1, 1},
    {"ForceFailure", 1, 1},
    {"SubTree", 1, 1},
    {"Repeat", 1, 1, {{"num_cycles", true, -1, 3}}},
    {"RetryUntilSuccessful", 1, 1, {{"num_attempts", true, -1, 3}}},
    {"KeepRunningUntilFailure", 1, 1},
    {"Timeout", 1, 1, {{"msec", true, 0, 3, 70}}},
    {"Delay", 1, 1, {{"delay_msec", true, 0, 3, 70}}},
    {"RunOnce", 1, 1, {{"then_skip", false, 0, 0, 1, {"true", "false"}}}},
    {"SingleTrigger", 1, 1},
    {"RateController", 1, 1, {{"hz", false, 1, 20}}},
    {"Cooldown",
     1,
     1,
     {{"msec", true, 0, 3, 70}, {"if_cooling", false, 0, 0, 1, {"SUCCESS", "RUNNING", "SKIPPED"}}}},
    {"CircuitBreaker",
     1,
     1,
     {{"max_failures", false, 1, 3},
      {"period_msec", false, 0, 5, 70},
      {"open_msec", false, 0, 5, 70},
      {"if_open", false, 0, 0, 1, {"SUCCESS", "RUNNING", "SKIPPED"}}}},
    {"SkipUnlessUpdated", 1, 1, {kEntry}},
    {"WaitValueUpdate", 1, 1, {kEntry}},
    {"Precondition",
     1,
     1,
     {{"if", true, 0, 0, 1, {"@k == 'a'", "@j == 'b'"}},
      {"else", false, 0, 0, 1, {"SUCCESS", "RUNNING", "SKIPPED"}}}},
    {"LoopString",
     1,
     1,
     {{"queue", true, 0, 0, 1, {"", "a", "b;a;c"}},
      {"value", false, 0, 0, 1, {"{@k}", "{@j}"}},
      {"if_empty", false, 0, 0, 1, {"FAILURE", "RUNNING", "SKIPPED"}}}},
    {"LoopInt", 1, 1, {{"queue", true, 0, 0, 1, {"1;2"}}}},
    {"LoopDouble", 1, 1, {{"queue", true, 0, 0, 1, {"4;2.5;1;2.5"}}, kMeasured}},
    {"Consecutive", 1, 1, {{"successes", false, 0, 3}, {"failures", false, 0, 3}}},
    {"Debounce", 1, 1, {{"success_msec", false, 0, 3, 70}, {"failure_msec", false, 0, 3, 70}}},
};

const std::vector<Generator::NodeKind> Generator::kLeaves = {
    {"AlwaysSuccess", 0, 0},
    {"AlwaysFailure", 0, 0},
    {"Sleep", 0, 0, {{"msec", true, 0, 3, 70}}},
    {"WasEntryUpdated", 0, 0, {kEntry}},
    {"SetBlackboard",
     0,
     0,
     {{"value", true, 0, 0, 1, {"a", "b", "c", "{@k}", "{@j}"}},
      {"output_key", true, 0, 0, 1, {"{@k}", "{@j}"}}}},
    {"SetBlackboard",
     0,
     0,
     {{"value", true, 0, 0, 1, {"1", "2", "2.5", "3", "4"}},
      {"output_key", true, 0, 0, 1, {"{@x}", "{@y}"}}}},
    {"Hysteresis",
     0,
     0,
     {kMeasured, {"low", true, 1, 2}, {"high", true, 0, 0, 1, {"1.5", "2.5", "3"}}}},
    {"UnsetBlackboard", 0, 0, {{"key", true, 0, 0, 1, {"{@k}", "{@j}"}}}},
    {"Script", 0, 0, {{"code", true, 0, 0, 1, {"@k := 'b'", "@j := 'a'"}}}},
    {"ScriptCondition", 0, 0, {{"code", true, 0, 0, 1, {"@k == 'b'", "@j == 'a'"}}}},
    {"TestNode",
     0,
     0,
     {{"return_status", false, 0, 0, 1, {"SUCCESS", "FAILURE", "SKIPPED"}},
      {"async_delay", false, 0, 3, 70}}},
};

void WriteFromOutside(SideBySide& both, Generator& generator, bool first) {
  const std::int64_t g = generator.Uniform(0, 9);
  if (first || generator.Uniform(0, 1) == 0) both.Write("g", g, std::to_string(g));
  const std::string text(1, static_cast<char>('a' + generator.Uniform(0, 5)));
  if (text <= "c") both.Write(generator.Uniform(0, 1) == 0 ? "k" : "j", text, text);
  const int number = generator.Uniform(0, 9);
  if (number <= 4) both.Write<double>("x", number, std::to_string(number));
}

TEST(RandomTrees, DoWhatTheOracleDoes) {
  constexpr unsigned kTrees = 3000;
  constexpr int kTicks = 30;
  for (unsigned seed = 1; seed <= kTrees; ++seed) {
    Generator generator(seed);
    const Shape shape = generator.Tree(4);
    // RUNNING, SUCCESS, FAILURE, SKIPPED, and now and then an exception.
    SideBySide both(shape, [&generator] {
      const int choice = generator.Uniform(1, 20);
      return choice == 20 ? SideBySide::kThrow : 1 + choice % 4;
    });
    if (seed % 2 == 1) both.Listen();
    both.Write<std::string>("hooks", "", "");
    for (int tick = 0; tick < kTicks; ++tick) {
      WriteFromOutside(both, generator, tick == 0);
      both.Tick();
      if (generator.Uniform(0, 9) == 0) both.Halt();
      both.Advance(std::chrono::milliseconds(generator.Uniform(0, 100)));
      const std::string difference = both.Difference();
      ASSERT_EQ(difference, "") << "seed " << seed << ", tick " << tick;
    }
  }
}

}  // namespace
}  // namespace coppice::conformance
