#include "editor/commands/difference_commands.h"

#include "editor/commands/run_commands.h"

namespace coppice::editor {
namespace {

// From the last one to the first and back; `at` == count: none is selected.
std::size_t Neighbour(std::size_t at, std::size_t count, bool forward) {
  if (at >= count) return forward ? 0 : count - 1;
  return (at + (forward ? 1 : count - 1)) % count;
}

std::string Numbered(std::size_t at, std::size_t count) {
  return "Difference " + std::to_string(at + 1) + " of " + std::to_string(count);
}

void StepVersions(EditorState& state, bool forward) {
  Comparison& shown = *state.canvas.comparison;
  const std::size_t count = shown.differences().size();
  if (count == 0) return state.Notify("the two versions do not differ", state.now);
  shown.Select(Neighbour(shown.selected(), count, forward), state.screen.canvas_size);
  state.Notify(Numbered(shown.selected(), count), state.now);
}

void StepRuns(EditorState& state, const RunComparison& result, bool forward) {
  const std::size_t count = result.differences.size();
  if (count == 0) return state.Notify("the two runs do not differ", state.now);
  const std::size_t at = state.run.comparison.selected.value_or(count);
  ShowRunDifference(state, Neighbour(at, count, forward));
  state.run.tab = RunTab::kComparison;
  state.Notify(Numbered(*state.run.comparison.selected, count), state.now);
}

void StepDifference(EditorState& state, bool forward) {
  if (state.canvas.comparison) return StepVersions(state, forward);
  if (const RunComparison* result = ShownRunComparison(state)) {
    return StepRuns(state, *result, forward);
  }
  state.Notify("nothing is compared: Alt+D compares versions, COMPARE two runs", state.now, true);
}

}  // namespace

void AddDifferenceCommands(EditorState& state) {
  state.commands.Add({"difference.next", "Next difference", {'N', kAlt}, [&state] {
                        StepDifference(state, true);
                      }});
  state.commands.Add({"difference.previous", "Previous difference", {'N', kAlt | kShift}, [&state] {
                        StepDifference(state, false);
                      }});
}

const RunComparison* ShownRunComparison(const EditorState& state) {
  const RunView* run = state.workspace.run();
  const ShownComparison& shown = state.run.comparison;
  return run && shown.result && shown.first == run->name() ? &*shown.result : nullptr;
}

void ShowRunDifference(EditorState& state, std::size_t difference) {
  const RunDifference& shown = state.run.comparison.result->differences[difference];
  state.run.comparison.selected = difference;
  GoToRunNode(state, shown.first_tick, shown.what);
}

void GoToRunNode(EditorState& state, std::uint64_t tick, const std::string& path) {
  RunView* run = state.workspace.run();
  if (!run || !run->tree()) return;
  run->playhead().GoToTick(run->run().recording().Find(tick));
  const auto& nodes = run->tree()->description()->nodes;
  for (NodeIndex i{0}; i < nodes.size(); ++i) {
    if (nodes[i].path == path) return SelectRunNode(state, i);
  }
}

}  // namespace coppice::editor
