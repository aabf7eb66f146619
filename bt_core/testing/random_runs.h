// Runs a tree many times with leaves that do by chance what leaves may do, on simulated time, and
// counts what every node did: what no run has reached, what never failed, what threw.
//
//   RandomRuns runs(program, {.seed = 7});
//   for (int i = 0; i < 1000; ++i) runs.Run();
//   runs.coverage().nodes[3].results_of(Status::kFailure);
//
// The run number i has the seed `seed + i`, so each can be had again alone.
#ifndef COPPICE_BT_CORE_TESTING_RANDOM_RUNS_H_
#define COPPICE_BT_CORE_TESTING_RANDOM_RUNS_H_

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/engine/program.h"
#include "bt_core/testing/scenario.h"

namespace coppice {

struct RandomRunOptions {
  std::uint64_t seed = 1;
  /// Leaves that no rule of it fits have their chances from default_leaves.h.
  RandomPlay play;
  /// What is more important. Keys before the first tick (see CheckKeyValue in scenario_player.h),
  /// and scripts for nodes that are played, as a step of a scenario gives them.
  std::vector<KeyValue> set;
  std::vector<PlacedRule> scripts;
  Duration period = std::chrono::milliseconds(100);  ///< from tick to tick
  std::uint64_t most_ticks = 10000;                  ///< a run that is not done then is broken off
};

struct NodeCoverage {
  std::string path;
  std::array<std::uint64_t, 5> results{};  ///< of ticks, by Status; at IDLE: how often halted

  std::uint64_t results_of(Status status) const {
    return results[static_cast<std::size_t>(status)];
  }
  std::uint64_t ticks() const { return results[1] + results[2] + results[3] + results[4]; }
};

/// Something that must not happen: an exception, or a tree that asks for the next tick at once for
/// ever and so takes all of a processor.
struct RandomFinding {
  std::string node;  ///< path; empty: the whole tree
  std::string text;
  std::uint64_t times = 0;
  std::uint64_t seed = 0;  ///< of the first run that had it
  std::uint64_t tick = 0;  ///< in that run
};

struct Coverage {
  std::uint64_t first_seed = 0;
  std::uint64_t runs = 0;
  std::uint64_t ticks = 0;
  std::array<std::uint64_t, 5> results{};  ///< of runs, by Status; at RUNNING: broken off
  std::vector<NodeCoverage> nodes;         ///< in the order of the tree
  std::vector<RandomFinding> findings;     ///< in the order of the first time
};

class RandomRuns {
 public:
  RandomRuns(std::shared_ptr<const Program> program, RandomRunOptions options);

  /// One more run.
  void Run();
  const Coverage& coverage() const { return coverage_; }
  const Program& program() const { return *program_; }
  const RandomPlay& play() const { return options_.play; }

 private:
  class Watcher;

  void Find(std::string node, std::string text, std::uint64_t tick);

  std::shared_ptr<const Program> program_;
  RandomRunOptions options_;
  std::vector<MockRule> rules_;  // of all leaves
  Coverage coverage_;
};

/// Of each list the value that the run of this seed gets.
std::vector<KeyValue> ChosenKeys(const std::vector<std::vector<KeyValue>>& choices,
                                 std::uint64_t seed);

/// Paths of nodes that were never ticked.
std::vector<std::string> NeverTicked(const Coverage& coverage);
/// Paths of nodes that were ticked and never returned that.
std::vector<std::string> NeverReturned(const Coverage& coverage, Status status);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_RANDOM_RUNS_H_
