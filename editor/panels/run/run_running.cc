#include <algorithm>
#include <vector>

#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {

void DrawRunning(const Ui& ui, EditorState& state, RunView& run) {
  const auto& nodes = run.tree()->description()->nodes;
  const TreeShape shape = ShapeOf(*run.tree()->description());
  const auto& states = run.state().states;
  std::vector<NodeIndex> running;
  for (NodeIndex i{0}; i < states.size() && i < nodes.size(); ++i) {
    if (states[i].status == Status::kRunning && shape[i].end == i + 1) running.push_back(i);
  }
  std::stable_sort(running.begin(), running.end(), [&states](NodeIndex a, NodeIndex b) {
    return states[a].since < states[b].since;
  });
  if (running.empty()) Hint(ui, "Nothing is running in this tick. Running leaves are listed here.");
  for (const NodeIndex node : running) {
    const Row row = NextRow(ui, "run/running/" + nodes[node].path, false);
    if (row.clicked) SelectRunNode(state, node);
    if (!row.visible) continue;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = 8 * ui.scale;
    const std::string seconds =
        DurationText(std::chrono::duration<double>(run.state().now - states[node].since).count());
    const TextStyle time{Face::kBold, 12, ui.palette.running_text};
    const float width = ui.Width(seconds, time);
    ui.RowText(list, {row.box.max.x - pad - width, row.box.min.y}, row.box.height(), seconds, time);
    const TextStyle name{Face::kSans, 12, ui.palette.text};
    ui.RowText(list, row.box.min + Point{pad, 0}, row.box.height(),
               ui.CutStart(nodes[node].path, name, row.box.width() - width - 3 * pad), name);
  }
}

}  // namespace coppice::editor
