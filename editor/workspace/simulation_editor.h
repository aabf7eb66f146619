// What the user does to the simulation that is shown. Where he looks is where it goes on: if the
// playhead stands in the past, the simulation is taken back to there first.
//
//   SimulationEditor simulate(state, ui.now);
//   simulate.Tick();
//
// What cannot be done is said in state.notice. Cheap to make; keeps nothing.
#ifndef COPPICE_EDITOR_WORKSPACE_SIMULATION_EDITOR_H_
#define COPPICE_EDITOR_WORKSPACE_SIMULATION_EDITOR_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

class SimulationEditor {
 public:
  SimulationEditor(EditorState& state, double now) : state_(state), now_(now) {}

  /// Begins a simulation of the shown tree of a file, in the place of the one before, and shows it.
  void Start();
  void End();
  /// True if the shown run is the simulation.
  bool IsShown() const;

  void PlayOrPause();
  void Tick();
  void TickUntilChange();
  /// Until the selected node is ticked.
  void TickUntilTicked();
  void Back();
  void Halt();
  void Restart();
  void PlayAgain();
  void ChangeSpeed(double factor);

  /// Begins anew by chance, as the scenarios beside the tree say; an empty text: always the same.
  ///
  Outcome SetSeed(const std::string& text);
  /// Ticks so often, or until the tree is done.
  Outcome RunTicks(const std::string& text);
  /// The same so often, beside the simulation, with the scripts and keys that it was given; shows
  /// what is reached.
  Outcome RunOften(const std::string& text);
  /// Simulates the run that had it, up to that tick.
  void GoToFinding(const RandomFinding& finding);

  /// The selected node in the simulation; kNoNode if none is selected or no script plays it.
  NodeIndex SelectedLeaf() const;
  /// From now on the selected leaf returns that; a paused simulation ticks at once.
  void Finish(Status status);
  /// The same with words, see simulation/script_text.h.
  Outcome SetScript(const std::string& text);
  /// "battery_level = 0.2"
  Outcome SetKey(const std::string& assignment);

  /// Saves what was done as a test beside its file.
  Outcome SaveAsScenario(const std::string& name);
  Outcome SaveAsRecord(const std::string& path);

  void RunScenarios();
  /// Shows where a test stands, in its tree.
  void ShowTest(const ScenarioTest& test);

 private:
  // Brings the simulation to the moment that is shown; null if none is shown.
  Simulation* AtPlayhead();
  // The same, to tick there: what comes is shown.
  Simulation* GoOn();
  void SetLeaf(NodeIndex leaf, const MockScript& script);

  EditorState& state_;
  const double now_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_SIMULATION_EDITOR_H_
