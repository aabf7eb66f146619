#include "editor/commands/simulation_commands.h"

#include <string>
#include <utility>
#include <vector>

#include "editor/simulation/script_text.h"
#include "editor/workspace/simulation_editor.h"

namespace coppice::editor {
namespace {

constexpr Key kF5 = kKeyF1 + 4;
constexpr Key kF10 = kKeyF1 + 9;

class SimulationCommands {
 public:
  explicit SimulationCommands(EditorState& state) : state_(state) {}

  void AddAll() {
    AddAlways("sim.start", "Simulate the tree", {kF5}, &SimulationEditor::Start);
    AddAlways("sim.tests", "Run the tests", {'R', kCtrl | kShift}, &SimulationEditor::RunScenarios);
    state_.commands.Add({"tile.tests",
                         "Tests tile",
                         {kKeyF1 + 10, kShift},
                         [&s = state_] { s.screen.tiles.tests = !s.screen.tiles.tests; },
                         nullptr,
                         {},
                         [&s = state_] { return s.screen.tiles.tests; }});
    AddTime();
    AddChance();
    AddLeaf();
    AddPrompts();
  }

 private:
  using Do = void (SimulationEditor::*)();

  void AddAlways(std::string id, std::string title, KeyChord keys, Do what) {
    state_.commands.Add({std::move(id), std::move(title), keys,
                         [&s = state_, what] { (SimulationEditor(s, s.now).*what)(); }});
  }

  // What counts while the simulation is shown.
  void Add(std::string id, std::string title, KeyChord keys,
           std::function<void(SimulationEditor)> run) {
    state_.commands.Add({std::move(id), "Simulation: " + std::move(title), keys,
                         [&s = state_, run = std::move(run)] {
                           const SimulationEditor editor(s, s.now);
                           if (editor.IsShown()) return run(editor);
                           s.Notify("no simulation is shown: F5 begins one", s.now, true);
                         },
                         [&s = state_] { return SimulationEditor(s, s.now).IsShown(); }});
  }

  void AddTime() {
    Add("sim.play", "run or pause", {kKeySpace}, [](SimulationEditor e) { e.PlayOrPause(); });
    Add("sim.tick", "one tick", {kF10}, [](SimulationEditor e) { e.Tick(); });
    Add("sim.change", "tick until something changes", {kF10, kShift},
        [](SimulationEditor e) { e.TickUntilChange(); });
    Add("sim.back", "take back a tick", {kKeyBackspace}, [](SimulationEditor e) { e.Back(); });
    Add("sim.faster", "faster", {'='}, [](SimulationEditor e) { e.ChangeSpeed(2); });
    Add("sim.slower", "slower", {'-'}, [](SimulationEditor e) { e.ChangeSpeed(0.5); });
    Add("sim.restart", "start over", {kF5, kCtrl | kShift},
        [](SimulationEditor e) { e.Restart(); });
    Add("sim.again", "the same again with the tree as it is now", {kF5, kCtrl},
        [](SimulationEditor e) { e.PlayAgain(); });
    Add("sim.halt", "halt the tree", {}, [](SimulationEditor e) { e.Halt(); });
    Add("sim.end", "end", {kF5, kShift}, [](SimulationEditor e) { e.End(); });
  }

  void AddChance() {
    AddAsking("sim.chance", "random leaves", {'X'},
              "Seed for leaves that act at random; empty: they always do the same",
              &SimulationEditor::SetSeed, [](const Simulation& simulation) {
                return simulation.chance() ? std::to_string(simulation.chance()->seed)
                                           : std::string("1");
              });
    AddAsking("sim.runs", "many random runs, and what they reach", {'X', kShift}, "How many runs",
              &SimulationEditor::RunOften, [](const Simulation&) { return std::string("1000"); });
    AddAsking("sim.ticks", "a number of ticks", {}, "How many ticks", &SimulationEditor::RunTicks,
              [](const Simulation&) { return std::string("100"); });
  }

  void AddAsking(std::string id, std::string title, KeyChord keys, const char* hint,
                 Outcome (SimulationEditor::*what)(const std::string&),
                 std::function<std::string(const Simulation&)> proposal) {
    Add(std::move(id), std::move(title), keys,
        [&s = state_, hint, what, proposal = std::move(proposal)](const SimulationEditor&) {
          s.Ask({hint,
                 [&s, what](const std::string& text) {
                   return (SimulationEditor(s, s.now).*what)(text);
                 },
                 {}},
                proposal(*s.simulator.get()));
        });
  }

  void AddLeaf() {
    AddFinish("sim.success", "the leaf returns SUCCESS", '1', Status::kSuccess);
    AddFinish("sim.failure", "the leaf returns FAILURE", '2', Status::kFailure);
    AddFinish("sim.running", "the leaf stays RUNNING", '3', Status::kRunning);
    AddFinish("sim.skipped", "the leaf returns SKIPPED", '4', Status::kSkipped);
  }

  void AddFinish(std::string id, std::string title, Key key, Status status) {
    Add(std::move(id), std::move(title), {key}, [status](SimulationEditor e) { e.Finish(status); });
  }

  void AddPrompts() {
    Add("sim.script", "what the leaf does", {kKeyEnter}, [&s = state_](const SimulationEditor& e) {
      const NodeIndex leaf = e.SelectedLeaf();
      if (leaf == kNoNode) return s.Notify("Select a leaf first", s.now, true);
      const std::string present = PrintScript(*s.simulator.get()->ScriptOf(leaf));
      s.Ask({"What the leaf does: SUCCESS, 2s FAILURE, RUNNING x3 SUCCESS, each FAILURE SUCCESS, "
             "80% SUCCESS 20% FAILURE 0s..2s",
             [&s](const std::string& text) { return SimulationEditor(s, s.now).SetScript(text); },
             {}},
            present);
    });
    Add("sim.set", "set a key", {'B', kCtrl}, [&s = state_](const SimulationEditor&) {
      s.Ask({"Set a key: key = value",
             [&s](const std::string& text) { return SimulationEditor(s, s.now).SetKey(text); },
             [&s](const std::string& typed) { return Keys(s, typed); }});
    });
    Add("sim.save_test", "save as a test", {'T', kCtrl | kShift},
        [&s = state_](const SimulationEditor&) {
          s.Ask({"Save as a test; its name says what the tree does",
                 [&s](const std::string& name) {
                   return SimulationEditor(s, s.now).SaveAsScenario(name);
                 },
                 {}});
        });
    Add("sim.save_record", "save as a record", {}, [&s = state_](const SimulationEditor&) {
      s.Ask(
          {"Save the simulation as a record: its path",
           [&s](const std::string& path) { return SimulationEditor(s, s.now).SaveAsRecord(path); },
           {}},
          "simulation.coppice");
    });
  }

  // The keys that begin so, with their values.
  static std::vector<Choice> Keys(EditorState& state, const std::string& typed) {
    std::vector<Choice> rows;
    const Simulation* simulation = state.simulator.get();
    if (!simulation) return rows;
    for (const std::string& key : simulation->Keys()) {
      const bool fits = typed.find('=') == std::string::npos ? key.rfind(typed, 0) == 0
                                                             : typed.rfind(key + " =", 0) == 0;
      if (!fits) continue;
      Choice row;
      row.title = key;
      row.note = simulation->ValueOf(key);
      row.kind = "key";
      row.run = [&state, key] { state.commands.Run("sim.set"), state.popup.text = key + " = "; };
      rows.push_back(std::move(row));
    }
    return rows;
  }

  EditorState& state_;
};

}  // namespace

void AddSimulationCommands(EditorState& state) { SimulationCommands(state).AddAll(); }

}  // namespace coppice::editor
