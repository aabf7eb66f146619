#include "editor/commands/help_commands.h"

#include <filesystem>
#include <string>

#include "editor/files/examples.h"
#include "editor/workspace/simulation_editor.h"
#include "editor/workspace/tour.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] = "delivery.xml";
constexpr char kRecord[] = "delivery.coppice";
constexpr char kSeed[] = "4";  // of a run in which something happens

bool OpenExample(EditorState& state, const std::string& name) {
  const std::string path = PathOfExample(name);
  if (state.services.open_file(path)) return true;
  state.Notify("the example cannot be opened: " + path, state.now, true);
  return false;
}

void Simulate(EditorState& state) {
  if (!OpenExample(state, kTree)) return;
  SimulationEditor simulation(state, state.now);
  simulation.Start();
  const Outcome seeded = simulation.SetSeed(kSeed);
  if (!seeded) return state.Notify(seeded.problem(), state.now, true);
  simulation.PlayOrPause();
}

}  // namespace

void AddHelpCommands(EditorState& state) {
  EditorState& s = state;
  CommandTable& commands = state.commands;
  commands.Add({"example.tree", "Example: a tree", {}, [&s] { OpenExample(s, kTree); }});
  commands.Add(
      {"example.record", "Example: a record of a run", {}, [&s] { OpenExample(s, kRecord); }});
  commands.Add({"example.robot", "Example: a simulated robot", {}, [&s] { Simulate(s); }});
  commands.Add({"help.tour", "Two-minute tour", {}, [&s] { StartTour(s); }});
  const auto is_on = [&s] { return ShownStep(s) != nullptr; };
  commands.Add({"tour.next", "Tour: next", {kKeyPageDown}, [&s] { StepTour(s, 1); }, is_on});
  commands.Add({"tour.back", "Tour: back", {kKeyPageUp}, [&s] { StepTour(s, -1); }, is_on});
  commands.Add({"tour.end", "Tour: end", {kKeyEscape}, [&s] { EndTour(s); }, is_on});
}

}  // namespace coppice::editor
