// Every word of child results, for every node type with up to three leaves: RUNNING, SUCCESS,
// FAILURE and SKIPPED at every tick of every leaf, and a halt after each tick.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "tests/conformance/side_by_side.h"

namespace coppice::conformance {
namespace {

using std::chrono::milliseconds;

constexpr Duration kBetweenTicks = milliseconds(100);

// Walks through all sequences of choices, each the length that the run asks for.
class Choices {
 public:
  int Choose() {
    constexpr int kFirst = static_cast<int>(Status::kRunning);
    if (next_ == taken_.size()) taken_.push_back(kFirst);
    return taken_[next_++];
  }
  // To the next sequence; false when all were there.
  bool Next() {
    constexpr int kLast = static_cast<int>(Status::kSkipped);
    next_ = 0;
    while (!taken_.empty() && taken_.back() == kLast) taken_.pop_back();
    if (taken_.empty()) return false;
    ++taken_.back();
    return true;
  }

 private:
  std::vector<int> taken_;
  std::size_t next_ = 0;
};

// Returns the number of runs. `halt_after` 0: only at the end. What outlives an activation goes on
// from run to run, unless each run has a tree of its own.
std::size_t RunAll(const Shape& shape, int ticks, int halt_after, bool anew = false) {
  Choices choices;
  const auto choose = [&choices] { return choices.Choose(); };
  auto both = std::make_unique<SideBySide>(shape, choose);
  std::size_t runs = 0;
  do {
    if (anew && runs > 0) both = std::make_unique<SideBySide>(shape, choose);
    for (int tick = 1; tick <= ticks; ++tick) {
      both->Tick();
      if (tick == halt_after) both->Halt();
      both->Advance(kBetweenTicks);
    }
    both->Halt();
    ++runs;
    const std::string difference = both->Difference();
    if (difference.empty()) continue;
    ADD_FAILURE() << difference;
    return runs;
  } while (choices.Next());
  return runs;
}

Shape Make(const std::string& type, int leaves,
           std::vector<std::pair<std::string, std::string>> attributes = {}) {
  return {type, std::move(attributes),
          std::vector<Shape>(static_cast<std::size_t>(leaves), {"Leaf", {}, {}})};
}

void ExpectSame(const Shape& shape, int ticks, bool anew = false) {
  for (int halt_after = 0; halt_after < ticks; ++halt_after) {
    const std::size_t runs = RunAll(shape, ticks, halt_after, anew);
    if (halt_after == 0) {
      EXPECT_GT(runs, 1U);
    }
    if (testing::Test::HasFailure()) return;
  }
}

std::string NameOf(const Shape& shape) {
  std::string name = shape.type;
  for (const auto& [key, text] : shape.attributes) name += "_" + key + "_" + text;
  name += "_" + std::to_string(shape.children.size());
  for (char& c : name) {
    if (c == '-') c = 'm';
  }
  return name;
}

class Control : public testing::TestWithParam<Shape> {};

// Nodes that tick all children in every tick have 4 to the power of 12 words for 4 ticks.
TEST_P(Control, DoesWhatTheOracleDoes) {
  static const std::set<std::string> wide = {"Parallel", "ParallelAll", "WorstOf",
                                             "NonblockingSequence"};
  const Shape& shape = GetParam();
  ExpectSame(shape, shape.children.size() == 3 && wide.count(shape.type) != 0 ? 3 : 4);
}

std::vector<Shape> WithUpToThreeChildren() {
  std::vector<Shape> shapes;
  for (const char* type : {"Sequence", "Fallback", "ReactiveSequence", "ReactiveFallback",
                           "AsyncSequence", "AsyncFallback", "SequenceWithMemory", "ParallelAll",
                           "WorstOf", "PipelineSequence", "NonblockingSequence", "RoundRobin"}) {
    for (int leaves = 1; leaves <= 3; ++leaves) shapes.push_back(Make(type, leaves));
  }
  for (const char* type : {"RandomSequence", "RandomSelector"}) {
    for (int leaves = 1; leaves <= 3; ++leaves) shapes.push_back(Make(type, leaves));
    for (const char* seed : {"1", "7"}) shapes.push_back(Make(type, 3, {{"seed", seed}}));
  }
  for (const char* type : {"IfThenElse", "WhileDoElse", "TryCatch"}) {
    for (int leaves = 2; leaves <= 3; ++leaves) shapes.push_back(Make(type, leaves));
  }
  for (const char* failures : {"-2", "-1", "0", "2"}) {
    shapes.push_back(Make("ParallelAll", 3, {{"max_failures", failures}}));
  }
  shapes.push_back(Make("Parallel", 3, {{"success_count", "-1"}, {"failure_count", "1"}}));
  shapes.push_back(Make("Parallel", 3, {{"success_count", "2"}, {"failure_count", "2"}}));
  shapes.push_back(Make("Parallel", 3, {{"success_count", "1"}, {"failure_count", "-1"}}));
  shapes.push_back(Make("RoundRobin", 2, {{"wrap_around", "true"}}));
  shapes.push_back(Make("RoundRobin", 3, {{"wrap_around", "true"}}));
  shapes.push_back(Make("TryCatch", 2, {{"catch_on_halt", "true"}}));
  shapes.push_back(Make("TryCatch", 3, {{"catch_on_halt", "true"}}));
  for (const char* retries : {"-1", "0", "1", "2"}) {
    shapes.push_back(Make("RecoveryNode", 2, {{"number_of_retries", retries}}));
  }
  return shapes;
}

INSTANTIATE_TEST_SUITE_P(, Control, testing::ValuesIn(WithUpToThreeChildren()),
                         [](const auto& instance) { return NameOf(instance.param); });

// All thresholds that make a difference, those out of range included.
TEST(ParallelConformance, AllThresholds) {
  for (int children = 1; children <= 3; ++children) {
    const int ticks = children == 3 ? 2 : 4;
    for (int success = -children - 1; success <= children + 1; ++success) {
      for (int failure = -children - 1; failure <= children + 1; ++failure) {
        const Shape shape = Make("Parallel", children,
                                 {{"success_count", std::to_string(success)},
                                  {"failure_count", std::to_string(failure)}});
        for (int halt_after = 0; halt_after < ticks; ++halt_after) {
          RunAll(shape, ticks, halt_after);
        }
      }
    }
  }
}

class Decorator : public testing::TestWithParam<Shape> {};

TEST_P(Decorator, DoesWhatTheOracleDoes) {
  ExpectSame(GetParam(), 6);
  ExpectSame(GetParam(), 4, true);
}

std::vector<Shape> Decorators() {
  std::vector<Shape> shapes;
  for (const char* type : {"Inverter", "ForceSuccess", "ForceFailure", "SubTree", "RunOnce",
                           "KeepRunningUntilFailure", "SingleTrigger", "Consecutive"}) {
    shapes.push_back(Make(type, 1));
  }
  const auto add = [&shapes](const char* type, const char* port,
                             const std::vector<const char*>& values) {
    for (const char* value : values) shapes.push_back(Make(type, 1, {{port, value}}));
  };
  add("Repeat", "num_cycles", {"1", "2", "3", "-1"});
  add("RetryUntilSuccessful", "num_attempts", {"1", "2", "3", "-1"});
  add("Timeout", "msec", {"0", "50", "100", "250"});
  add("Delay", "delay_msec", {"0", "100", "250"});
  add("RunOnce", "then_skip", {"false"});
  add("RateController", "hz", {"4", "10", "20"});
  add("Cooldown", "msec", {"0", "100", "150"});
  add("Consecutive", "successes", {"0", "1", "3"});
  add("Debounce", "success_msec", {"0", "100", "150"});
  shapes.push_back(Make("Cooldown", 1, {{"msec", "150"}, {"if_cooling", "RUNNING"}}));
  shapes.push_back(Make("Debounce", 1, {{"failure_msec", "250"}, {"initial", "SUCCESS"}}));
  shapes.push_back(Make("CircuitBreaker", 1,
                        {{"max_failures", "2"}, {"period_msec", "150"}, {"open_msec", "150"}}));
  shapes.push_back(Make("CircuitBreaker", 1,
                        {{"max_failures", "1"}, {"open_msec", "150"}, {"if_open", "RUNNING"}}));
  return shapes;
}

INSTANTIATE_TEST_SUITE_P(, Decorator, testing::ValuesIn(Decorators()),
                         [](const auto& instance) { return NameOf(instance.param); });

// All words of four measurements, below, at, between and above the thresholds. The leaf is ticked
// when Hysteresis fails.
TEST(HysteresisConformance, AllWords) {
  const std::vector<std::string> values = {"1", "2", "2.5", "3", "4"};
  for (std::size_t word = 0; word < 5 * 5 * 5 * 5; ++word) {
    std::string queue;
    for (std::size_t rest = word, k = 0; k < 4; rest /= 5, ++k) queue += values[rest % 5] + ";";
    queue.pop_back();
    for (const char* high : {"3", "2"}) {
      const Shape hysteresis = {
          "Hysteresis", {{"value", "{@x}"}, {"low", "2"}, {"high", high}}, {}};
      const Shape either = {"Fallback", {}, {hysteresis, {"Leaf", {}, {}}}};
      const Shape loop = {"LoopDouble", {{"queue", queue}, {"value", "{@x}"}}, {either}};
      SideBySide both(loop, [] { return static_cast<int>(Status::kSuccess); });
      for (int tick = 0; tick < 6; ++tick) both.Tick();
      ASSERT_EQ(both.Difference(), "");
    }
  }
}

// A loop of no rounds has its result without ticking the child.
TEST(LoopConformance, NoRounds) {
  for (const char* rounds : {"0", "-2"}) {
    EXPECT_EQ(RunAll(Make("Repeat", 1, {{"num_cycles", rounds}}), 3, 0), 1U);
    EXPECT_EQ(RunAll(Make("RetryUntilSuccessful", 1, {{"num_attempts", rounds}}), 3, 0), 1U);
  }
}

}  // namespace
}  // namespace coppice::conformance
