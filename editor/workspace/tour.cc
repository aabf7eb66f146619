#include "editor/workspace/tour.h"

#include <algorithm>

#include "editor/canvas/wheel.h"
#include "editor/workspace/simulation_editor.h"

namespace coppice::editor {
namespace {

bool HasSelection(EditorState& state) {
  const TreeView* view = state.workspace.view();
  return view && view->selected() != kNoSceneNode;
}

bool HasEdited(EditorState& state) {
  return state.workspace.project().history().done() > state.tour.steps_done;
}

bool HasPalette(EditorState& state) { return state.popup.kind == Popup::kPalette; }

bool HasMenuOfThing(EditorState& state) {
  return !state.menu.open.empty() && state.menu.open.front().below.rfind("menu/", 0) != 0;
}

bool IsSimulated(EditorState& state) { return SimulationEditor(state, state.now).IsShown(); }

bool IsInThePast(EditorState& state) {
  const RunView* run = state.workspace.run();
  return run && !run->playhead().is_at_now();
}

void ShowTree(EditorState& state) {
  state.screen.tiles.others = true;
  if (!state.workspace.view() && !state.workspace.file()) state.commands.Run("example.tree");
}

void ShowOutline(EditorState& state) { state.screen.tiles.outline = true; }
void ShowInspector(EditorState& state) { state.screen.tiles.inspector = true; }
void ShowTypes(EditorState& state) { state.screen.tiles.types = true; }

void ShowRun(EditorState& state) {
  state.screen.tiles.timeline = state.screen.tiles.run = true;
  if (!state.workspace.run()) state.commands.Run("sim.start");
}

std::string_view Wheel(const EditorState& state) { return WheelHint(state.screen.wheel_zooms); }

const std::vector<TourStep> kSteps = {
    {"canvas", "The tree",
     "Nodes stand in the order in which they run. Click one. Drag the empty canvas to move it.",
     ShowTree, HasSelection, Wheel},
    {"outline", "The same as rows",
     "Each node is a row here too; while a tree runs, with its status and its seconds.",
     ShowOutline, nullptr},
    {"inspector", "Everything about the node",
     "Name, ports, guards. Change a value: that is one step, and Ctrl+Z undoes it.", ShowInspector,
     HasEdited},
    {"types", "Nodes to add",
     "Drag one onto the canvas, or press Tab and type a few letters of its name.", ShowTypes,
     HasEdited},
    {"canvas", "What can be done here",
     "Right-click a node, a line or the empty canvas to see it, with its keys.", nullptr,
     HasMenuOfThing},
    {"bar/palette", "Everything by name",
     "Ctrl+P finds any command, node, tree or robot by a few letters of its name.", nullptr,
     HasPalette},
    {"menu/simulate", "Try it without a robot",
     "F5 simulates the tree: you decide what the leaves return, or let chance decide.", nullptr,
     IsSimulated},
    {"timeline", "What has happened",
     "Each node has a lane. F10 ticks; click a lane, and the window shows that moment.", ShowRun,
     IsInThePast},
    {"run", "Why",
     "Which node decided what the selected one returned. It is the same for robots "
     "and records.",
     ShowRun, nullptr},
    {"menu/help", "All keys",
     "F1 lists all commands with their keys and lets you change them. That is all.", nullptr,
     nullptr}};

void Enter(EditorState& state, int step) {
  Tour& tour = state.tour;
  tour.step = step;
  const TourStep* const shown = ShownStep(state);
  if (!shown) return EndTour(state);
  if (shown->prepare) shown->prepare(state);
  tour.steps_done = state.workspace.project().history().done();
  tour.was_done = shown->is_done && shown->is_done(state);
}

}  // namespace

std::string TextOf(const TourStep& step, const EditorState& state) {
  std::string text(step.text);
  if (step.end) text.append(" ").append(step.end(state));
  return text;
}

const std::vector<TourStep>& TourSteps() { return kSteps; }

const TourStep* ShownStep(const EditorState& state) {
  const int step = state.tour.step;
  const bool is_shown = step >= 0 && step < static_cast<int>(kSteps.size());
  return is_shown ? &kSteps[static_cast<std::size_t>(step)] : nullptr;
}

void StartTour(EditorState& state) { Enter(state, 0); }

void StepTour(EditorState& state, int by) {
  if (ShownStep(state)) Enter(state, std::max(state.tour.step + by, 0));
}

void EndTour(EditorState& state) { state.tour = {}; }

void UpdateTour(EditorState& state) {
  const TourStep* const step = ShownStep(state);
  if (!step || !step->is_done) return;
  const bool is_done = step->is_done(state);
  if (is_done && !state.tour.was_done) return StepTour(state, 1);
  state.tour.was_done = is_done;
}

}  // namespace coppice::editor
