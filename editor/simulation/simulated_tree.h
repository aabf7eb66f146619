// One tree that is played by scripts on simulated time, and tells its history as a robot does.
//
//   SimulatedTree tree(program, &run);        // editor/timeline/run.h, or a Recording
//   tree.Play(step);                          // bt_core/testing/scenario.h
#ifndef COPPICE_EDITOR_SIMULATION_SIMULATED_TREE_H_
#define COPPICE_EDITOR_SIMULATION_SIMULATED_TREE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bt_core/frames/follower.h"
#include "bt_core/testing/scenario_player.h"

namespace coppice::editor {

/// How a tree is run by chance.
struct Chance {
  std::uint64_t seed = 0;
  RandomPlay play;  ///< what the file of its scenarios says (bt_core/testing/random_suite.h)
};

/// What leaves do that nobody has told anything, in a tree that is run by chance or not.
std::vector<PlacedRule> LeavesOf(const Program& program, const std::optional<Chance>& chance);

class SimulatedTree final : private TickSink {
 public:
  /// `handler` is told the tree and everything that happens; null: nobody is told for now. By
  /// chance, keys get their values before the first tick, and leaves that nobody has told anything
  /// do what they do (default_leaves.h).
  SimulatedTree(std::shared_ptr<const Program> program, std::optional<Chance> chance,
                HistoryHandler* handler);
  ~SimulatedTree() override;

  StepOutcome Play(const ScenarioStep& step) { return player_.Play(step); }
  /// Goes on with another program.
  void Reload(std::shared_ptr<const Program> program);

  /// From now on the handler is told. It has been told of a tree of this program before, if
  /// `knows_tree`; how the tree stands it learns in any case.
  void TellTo(HistoryHandler& handler, bool knows_tree);

  const std::shared_ptr<const Program>& program() const { return program_; }
  const std::optional<Chance>& chance() const { return chance_; }
  const ScenarioPlayer& player() const { return player_; }
  Time now() const { return player_.clock().Now(); }
  const HistoryFollower& state() const { return *follower_; }

 private:
  void OnTick(const TickEvents& events) override;
  void OnJump(const Executor& executor) override;
  HistoryState StateNow(HistoryState::Cause cause) const;
  void Describe(HistoryHandler& handler) const;
  void SetKeysByChance();

  std::shared_ptr<const Program> program_;
  std::optional<Chance> chance_;
  ScenarioPlayer player_;
  HistoryHandler* handler_;
  std::optional<HistoryFollower> follower_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_SIMULATED_TREE_H_
