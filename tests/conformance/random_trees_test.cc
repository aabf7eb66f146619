// Random trees of all node types, run for some dozen ticks with random results, halts and time.
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
    if (depth == 0 || Uniform(0, 9) == 0) {
      const int kind = Uniform(0, 9);
      if (kind == 0) return {"AlwaysSuccess", {}, {}};
      if (kind == 1) return {"AlwaysFailure", {}, {}};
      return {"Leaf", {}, {}};
    }
    return Uniform(0, 1) == 0 ? Control(depth) : Decorator(depth);
  }

 private:
  Shape Control(int depth) {
    static const char* const kTypes[] = {"Sequence", "Fallback", "ReactiveSequence",
                                         "ReactiveFallback", "Parallel"};
    Shape shape{kTypes[Uniform(0, 4)], {}, {}};
    const int children = Uniform(1, 4);
    if (shape.type == "Parallel") {
      shape.ports = {Uniform(-children - 1, children), Uniform(-children - 1, children)};
    }
    for (int i = 0; i < children; ++i) shape.children.push_back(Tree(depth - 1));
    return shape;
  }

  Shape Decorator(int depth) {
    static const char* const kTypes[] = {"Inverter", "ForceSuccess", "ForceFailure",
                                         "SubTree",  "Repeat",       "RetryUntilSuccessful",
                                         "Timeout",  "Delay"};
    Shape shape{kTypes[Uniform(0, 7)], {}, {}};
    if (shape.type == "Repeat" || shape.type == "RetryUntilSuccessful") {
      shape.ports = {Uniform(-1, 3)};
    } else if (shape.type == "Timeout" || shape.type == "Delay") {
      shape.ports = {Uniform(0, 3) * 70};
    }
    shape.children.push_back(Tree(depth - 1));
    return shape;
  }

  std::mt19937 random_;
};

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
    for (int tick = 0; tick < kTicks; ++tick) {
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
