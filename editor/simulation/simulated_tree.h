// One tree that is played by scripts on simulated time, and tells its history as a robot does.
//
//   SimulatedTree tree(program, &run);        // editor/timeline/run.h, or a Recording
//   tree.Play(step);                          // bt_core/testing/scenario.h
#ifndef COPPICE_EDITOR_SIMULATION_SIMULATED_TREE_H_
#define COPPICE_EDITOR_SIMULATION_SIMULATED_TREE_H_

#include <memory>
#include <optional>
#include <vector>

#include "bt_core/history/follower.h"
#include "bt_core/testing/scenario_player.h"

namespace coppice::editor {

/// What leaves do that nobody has told anything: a condition is true, an action takes a second and
/// succeeds. Without a model, what is named IsSomething or HasSomething is taken for a condition.
std::vector<PlacedRule> DefaultLeaves(const Program& program);

class SimulatedTree final : private TickSink {
 public:
  /// `handler` is told the tree and everything that happens; null: nobody is told for now.
  SimulatedTree(std::shared_ptr<const Program> program, HistoryHandler* handler);
  ~SimulatedTree() override;

  StepOutcome Play(const ScenarioStep& step) { return player_.Play(step); }
  /// Goes on with another program.
  void Reload(std::shared_ptr<const Program> program);

  /// From now on the handler is told. It has been told of a tree of this program before, if
  /// `knows_tree`; how the tree stands it learns in any case.
  void TellTo(HistoryHandler& handler, bool knows_tree);

  const std::shared_ptr<const Program>& program() const { return program_; }
  const ScenarioPlayer& player() const { return player_; }
  Time now() const { return player_.clock().Now(); }
  const HistoryFollower& state() const { return *follower_; }

 private:
  void OnTick(const TickEvents& events) override;
  void OnJump(const Executor& executor) override;
  HistoryState StateNow(HistoryState::Cause cause) const;
  void Describe(HistoryHandler& handler) const;

  std::shared_ptr<const Program> program_;
  ScenarioPlayer player_;
  HistoryHandler* handler_;
  std::optional<HistoryFollower> follower_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_SIMULATED_TREE_H_
