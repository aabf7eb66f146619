#include "editor/workspace/run_test_maker.h"

#include <cstddef>
#include <utility>

#include "bt_core/analysis/play/scenario_of.h"

namespace coppice::editor {
namespace {

// The file of the tree; null if it is not open.
const OpenFile* FileOf(const Workspace& workspace, const RecordedScenario& recorded) {
  const OpenFile* other = nullptr;
  for (const OpenFile& file : workspace.files()) {
    if (file.forest->Find(recorded.tree_id) < 0) continue;
    if (file.path == recorded.tree_file) return &file;
    if (!other) other = &file;
  }
  return other;
}

std::pair<std::size_t, std::size_t> ShownTicks(EditorState& state, const RunView& run) {
  const auto& range = state.run.timelines[run.name()].range;
  if (!range) return {0, run.run().size()};
  return {run.run().TickAt(range->first), run.run().TickAt(range->second) + 1};
}

}  // namespace

Outcome SaveRunAsTest(EditorState& state, const std::string& name, double now) {
  const RunView* run = state.workspace.run();
  if (!run || !run->run().has_tree() || run->run().size() == 0)
    return Problem{"nothing has happened yet"};
  if (name.empty()) return Problem{"a name is needed"};
  const auto [first, end] = ShownTicks(state, *run);
  Diagnostics diagnostics;
  const auto recorded = ScenarioOf(run->run().recording(), first, end, name, diagnostics);
  if (!recorded) return Problem{diagnostics.all().back().message};
  const OpenFile* file = FileOf(state.workspace, *recorded);
  if (!file) {
    return Problem{"open the file with the tree " + recorded->tree_id +
                   " first: the test lies beside it"};
  }
  const int main = file->forest->main_tree();
  const bool is_main = main >= 0 && file->forest->Find(recorded->tree_id) == main;
  const std::string path =
      SaveScenario(recorded->scenario, file->path, is_main ? "" : recorded->tree_id,
                   state.workspace.model_files(), recorded->models, diagnostics);
  if (path.empty()) return Problem{diagnostics.all().back().message};
  state.Notify("\"" + name + "\" is a test in " + path.substr(path.rfind('/') + 1) +
                   ", from tick " +
                   std::to_string(run->run().recording().ticks()[recorded->first_tick].number),
               now);
  state.screen.tiles.tests = true;
  state.tests.Look({file->path});
  return {};
}

}  // namespace coppice::editor
