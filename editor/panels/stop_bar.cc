#include <algorithm>

#include "editor/panels/panel.h"
#include "editor/panels/panels.h"

namespace coppice::editor {
namespace {

struct StopButton {
  const char* path;
  const char* text;
  const char* command;
  Status status;  // that the node is to have; kIdle: its own
};

constexpr StopButton kButtons[] = {
    {"stop/continue", "Continue", "run.continue", Status::kIdle},
    {"stop/step", "Step", "run.step_node", Status::kIdle},
    {"stop/success", "SUCCESS", "run.continue_success", Status::kSuccess},
    {"stop/failure", "FAILURE", "run.continue_failure", Status::kFailure},
    {"stop/skip", "SKIP", "run.continue_skipped", Status::kSkipped}};

}  // namespace

void DrawStopBar(const Ui& ui, EditorState& state, const Box& canvas) {
  const RunView* run = state.workspace.run();
  const TreeView* view = state.workspace.view();
  if (!run || !view || !run->playhead().is_at_now()) return;
  const DebugStop& stop = run->stop();
  if (stop.where != DebugStop::Where::kBefore && stop.where != DebugStop::Where::kAfter) return;
  const auto& nodes = view->scene()->node_of_uid;
  if (stop.node >= nodes.size() || nodes[stop.node] == kNoNode) return;
  Box node = view->camera.ToScreen(view->BoxAt(view->ShownOf(nodes[stop.node]), ui.now));
  node = {node.min + canvas.min, node.max + canvas.min};
  const float height = 22 * ui.scale;
  const float pad = 6 * ui.scale;
  const float lowest = std::max(canvas.max.y - height - pad, canvas.min.y + pad);
  const bool is_room_below = node.max.y + pad <= lowest;
  const float top = std::clamp(is_room_below ? node.max.y + pad : node.min.y - pad - height,
                               canvas.min.y + pad, lowest);
  float x = std::clamp(node.min.x, canvas.min.x + 4 * ui.scale,
                       std::max(canvas.max.x - 330 * ui.scale, canvas.min.x));
  // A window of its own: it lies above the canvas, for the mouse too.
  ImGui::SetCursorScreenPos({x, top});
  ImGui::BeginChild("stop", {330 * ui.scale, height}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground);
  for (const StopButton& button : kButtons) {
    const bool can = stop.where == DebugStop::Where::kBefore || &button < kButtons + 2;
    if (!can) continue;
    const float width = ui.Width(button.text, {Face::kSans, 12, 0}) + 16 * ui.scale;
    const Box at = {{x, top}, {x + width, top + height}};
    x += width + 3 * ui.scale;
    ui.Fill(*ImGui::GetWindowDrawList(), at, ui.palette.panel, 4);
    const Color tint =
        button.status == Status::kIdle ? ui.palette.accent : ui.palette.Of(button.status);
    if (ui.Button(button.path, at, button.text, false, tint)) state.commands.Run(button.command);
    ExplainCommand(ui, state.commands, button.command);
  }
  ImGui::EndChild();
}

}  // namespace coppice::editor
