// A simulation: a tree without a robot. The engine itself runs it; scripts play the leaves; time
// passes when the user says so.
//
//   Simulation simulation(program, run);           // a Run, or anything else that gets a history
//   simulation.SetKey("battery_level", "0.2");
//   simulation.SetScript(node, script);
//   simulation.Tick(std::chrono::milliseconds(100));
//   simulation.GoTo(3);                             // as it stood behind tick 3 of the run
//   Scenario test = simulation.Record("recharges when low");
//
// Everything that was done is kept as the steps of a scenario. A run is a function of them: going
// back plays them again up to a place, and another future begins there. The run keeps the old one
// too.
#ifndef COPPICE_EDITOR_SIMULATION_SIMULATION_H_
#define COPPICE_EDITOR_SIMULATION_SIMULATION_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/simulation/simulated_tree.h"

namespace coppice::editor {

class Simulation final : private HistoryHandler {
 public:
  /// `run` is told what happens; it must live longer.
  Simulation(std::shared_ptr<const Program> program, HistoryHandler& run);

  const std::shared_ptr<const Program>& program() const { return tree_->program(); }
  /// Since the beginning, on this way.
  Duration now() const { return SinceBeginning(tree_->now()); }
  /// Of a time of its run.
  static Duration SinceBeginning(Time time) { return time - kStart; }
  /// Since the beginning, on this way.
  std::uint64_t ticks() const { return tree_->player().tree().executor().ticks(); }
  const HistoryFollower& state() const { return tree_->state(); }
  /// What a script has written or the user has set; as text. Empty if the key has no value.
  std::string ValueOf(const std::string& key) const;
  /// All keys, as scenarios write them.
  std::vector<std::string> Keys() const;

  /// What a node does from the next tick on. False if no script plays it: it is built in.
  bool SetScript(NodeIndex node, const MockScript& script);
  /// What it does, or will do; null if no script plays it.
  const MockScript* ScriptOf(NodeIndex node) const;

  /// Writes a key before the next tick.
  Outcome SetKey(const std::string& key, const std::string& text);
  Outcome SetKey(const KeyValue& value);
  /// What is written before the next tick.
  const std::vector<KeyValue>& waiting_keys() const { return next_.set; }

  /// Lets time pass, then ticks. Returns what the root returned.
  Status Tick(Duration after);
  /// Ticks with this period until a node has another status, or the limit of time is over.
  Status TickUntilChange(Duration period, Duration limit);
  void Halt();

  /// Goes on with another version of the tree.
  void Reload(std::shared_ptr<const Program> program);

  /// Makes the tree as it was behind that tick of the run; if it has changed since, it is reloaded
  /// there. The run learns of it when the tree goes on from there: until then its end is what
  /// happened last. False if the run has not got this tick from here.
  bool GoTo(std::size_t tick);
  /// Makes the tree as it is at the end of the run.
  void GoToEnd() { GoToMove(told_); }
  /// Takes back the last tick; false at the beginning. A beginning is the new end of the run: it
  /// is no tick that one could look at.
  bool Back();
  /// The tick of the run behind which the tree stands; nothing at a beginning.
  std::optional<std::size_t> tick_of_run() const;
  /// Begins anew, with the tree as it is now.
  void Restart();
  /// Begins anew by chance, or, with nothing, with leaves that always do the same.
  void SetChance(std::optional<Chance> chance);
  const std::optional<Chance>& chance() const { return tree_->chance(); }
  /// True if the tree is begun anew when it is done, as random runs do for some time.
  bool is_begun_anew() const { return chance() && now() < chance()->play.lasts; }
  /// The same as this run of RandomRuns, which knows what was told here, up to a tick.
  void PlayRun(Chance chance, std::uint64_t ticks, Duration period);
  /// Of all that was told on this way, the last script of every node and the last value of every
  /// key.
  ScenarioStep Told() const;
  /// Begins anew and does the same again, with the tree as it is now.
  void PlayAgain();

  /// What was done on this way, as a test of the tree as it is now.
  Scenario Record(std::string name) const;
  /// What happened on this way, as the bytes of a record (docs/record_format.md).
  std::string ToRecord() const;

 private:
  static constexpr Time kStart{std::chrono::seconds(1)};  // of the clock of scenarios
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  // Something that was done. The first of a way begins a tree; others go on with another program,
  // or play a step.
  struct Move {
    std::size_t before = kNone;
    std::shared_ptr<const Program> program;
    std::optional<Chance> chance;  // of a tree that begins
    ScenarioStep step;
  };

  void OnTree(const TreeDescription& tree) override { run_.OnTree(tree); }
  void OnState(const HistoryState& state) override { run_.OnState(state); }
  void OnTick(const TickEvents& events) override;

  std::vector<std::size_t> Way(std::size_t to) const;
  std::vector<ScenarioStep> Steps() const;
  std::vector<ScenarioStep> StepsWithChosenKeys() const;
  void Begin(std::shared_ptr<const Program> program, std::optional<Chance> chance);
  StepOutcome Play(ScenarioStep step);
  void GoToMove(std::size_t move);
  std::size_t WithoutReloads(std::size_t move) const;
  void TellPlace();
  void StandAtEnd(std::size_t move);
  std::unique_ptr<SimulatedTree> Replay(std::size_t to, HistoryHandler* handler) const;

  HistoryHandler& run_;
  std::vector<Move> moves_;
  std::size_t at_ = kNone;
  std::size_t told_ = kNone;  // where the tree stands at the end of the run
  std::shared_ptr<const Program> told_program_;
  std::vector<std::size_t> move_of_tick_;
  ScenarioStep next_;  // gathers what the user sets before the next tick
  std::unique_ptr<SimulatedTree> tree_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SIMULATION_SIMULATION_H_
