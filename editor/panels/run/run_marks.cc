#include "editor/panels/run/run_marks.h"

namespace coppice::editor {

HeatMap RunHeat(EditorState& state, const TreeView& view) {
  const RunView* run = state.workspace.run();
  if (!run || !state.heat) return {};
  if (run->source().is_simulation() && state.run_tab == RunTab::kCoverage && run->tree() &&
      state.coverage.coverage()) {
    return state.coverage.Heat(*state.heat, *run->tree()->description(), *view.scene());
  }
  if (run->run().size() == 0) return {};
  state.figures.Update(run->run(), state.timelines[run->name()].range);
  return state.figures.Heat(*state.heat, *run->tree()->description(), *view.scene());
}

std::vector<Change> RunDifferences(const EditorState& state, const TreeView& view) {
  const RunView* run = state.workspace.run();
  const ShownComparison& shown = state.comparison;
  if (!run || !shown.result || shown.first != run->name()) return {};
  std::vector<Change> changes(view.scene()->nodes.size(), Change::kNone);
  const auto& nodes = run->tree()->description()->nodes;
  const auto& in_scene = view.scene()->node_of_uid;
  for (const RunDifference& difference : shown.result->differences) {
    for (std::size_t i = 0; i < nodes.size() && i < in_scene.size(); ++i) {
      if (in_scene[i] != kNoNode && nodes[i].path == difference.what) {
        changes[in_scene[i]] = Change::kChanged;
      }
    }
  }
  return changes;
}

}  // namespace coppice::editor
