// Every word of child results, for every node type with up to three leaves: RUNNING, SUCCESS,
// FAILURE and SKIPPED at every tick of every leaf, and a halt after each tick.
#include <gtest/gtest.h>

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

// Returns the number of runs. `halt_after` 0: only at the end.
std::size_t RunAll(const Shape& shape, int ticks, int halt_after) {
  Choices choices;
  SideBySide both(shape, [&choices] { return choices.Choose(); });
  std::size_t runs = 0;
  do {
    for (int tick = 1; tick <= ticks; ++tick) {
      both.Tick();
      if (tick == halt_after) both.Halt();
      both.Advance(kBetweenTicks);
    }
    both.Halt();
    ++runs;
    const std::string difference = both.Difference();
    if (difference.empty()) continue;
    ADD_FAILURE() << difference;
    return runs;
  } while (choices.Next());
  return runs;
}

Shape Make(const std::string& type, std::vector<int> ports, int leaves) {
  return {type, std::move(ports),
          std::vector<Shape>(static_cast<std::size_t>(leaves), {"Leaf", {}, {}})};
}

void ExpectSame(const Shape& shape, int ticks) {
  for (int halt_after = 0; halt_after < ticks; ++halt_after) {
    const std::size_t runs = RunAll(shape, ticks, halt_after);
    if (halt_after == 0) {
      EXPECT_GT(runs, 1U);
    }
    if (testing::Test::HasFailure()) return;
  }
}

class Control : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(Control, DoesWhatTheOracleDoes) {
  const auto& [type, leaves] = GetParam();
  ExpectSame(Make(type, {}, leaves), 4);
}

INSTANTIATE_TEST_SUITE_P(, Control,
                         testing::Combine(testing::Values("Sequence", "Fallback",
                                                          "ReactiveSequence", "ReactiveFallback"),
                                          testing::Values(1, 2, 3)),
                         [](const auto& instance) {
                           return std::string(std::get<0>(instance.param)) +
                                  std::to_string(std::get<1>(instance.param));
                         });

// All thresholds that make a difference, those out of range included.
TEST(ParallelConformance, OneChild) {
  for (int success = -3; success <= 2; ++success) {
    for (int failure = -3; failure <= 2; ++failure) {
      const Shape shape = Make("Parallel", {success, failure}, 1);
      RunAll(shape, 4, 0);
      RunAll(shape, 4, 2);
    }
  }
}

TEST(ParallelConformance, TwoChildren) {
  for (int success = -3; success <= 3; ++success) {
    for (int failure = -3; failure <= 3; ++failure) {
      const Shape shape = Make("Parallel", {success, failure}, 2);
      for (int halt_after = 0; halt_after < 3; ++halt_after) RunAll(shape, 3, halt_after);
    }
  }
}

TEST(ParallelConformance, ThreeChildrenAndAllThresholds) {
  for (int success = -4; success <= 4; ++success) {
    for (int failure = -4; failure <= 4; ++failure) {
      const Shape shape = Make("Parallel", {success, failure}, 3);
      for (int halt_after = 0; halt_after < 2; ++halt_after) RunAll(shape, 2, halt_after);
    }
  }
}

TEST(ParallelConformance, ThreeChildrenThatMustAllSucceedForFourTicks) {
  ExpectSame(Make("Parallel", {-1, 1}, 3), 4);
}

TEST(ParallelConformance, ThreeChildrenOneOfWhichMustSucceedForFourTicks) {
  ExpectSame(Make("Parallel", {1, -1}, 3), 4);
}

class Decorator : public testing::TestWithParam<Shape> {};

TEST_P(Decorator, DoesWhatTheOracleDoes) { ExpectSame(GetParam(), 5); }

INSTANTIATE_TEST_SUITE_P(
    , Decorator,
    testing::Values(Make("Inverter", {}, 1), Make("ForceSuccess", {}, 1),
                    Make("ForceFailure", {}, 1), Make("SubTree", {}, 1), Make("Repeat", {1}, 1),
                    Make("Repeat", {2}, 1), Make("Repeat", {3}, 1), Make("Repeat", {-1}, 1),
                    Make("RetryUntilSuccessful", {1}, 1), Make("RetryUntilSuccessful", {2}, 1),
                    Make("RetryUntilSuccessful", {3}, 1), Make("RetryUntilSuccessful", {-1}, 1),
                    Make("Timeout", {0}, 1), Make("Timeout", {50}, 1), Make("Timeout", {100}, 1),
                    Make("Timeout", {250}, 1), Make("Delay", {0}, 1), Make("Delay", {100}, 1),
                    Make("Delay", {250}, 1)),
    [](const auto& instance) {
      const Shape& shape = instance.param;
      if (shape.ports.empty()) return shape.type;
      return shape.type + (shape.ports[0] < 0 ? "ForEver" : std::to_string(shape.ports[0]));
    });

// A loop of no rounds has its result without ticking the child.
TEST(LoopConformance, NoRounds) {
  EXPECT_EQ(RunAll(Make("Repeat", {0}, 1), 3, 0), 1U);
  EXPECT_EQ(RunAll(Make("RetryUntilSuccessful", {0}, 1), 3, 0), 1U);
}

}  // namespace
}  // namespace coppice::conformance
