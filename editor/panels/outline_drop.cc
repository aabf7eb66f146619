#include "editor/panels/outline_drop.h"

#include <string>

#include "editor/panels/widgets/panel.h"
#include "editor/workspace/node_drop.h"

namespace coppice::editor {
namespace {

constexpr float kEdge = 0.28F;  // of the row, above and below

void PaintTarget(const Ui& ui, const DropTarget& target, float part, const Box& row, Color color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (target.place == DropPlace::kNode) return ui.Frame(list, row, color, 3 * ui.scale, 2);
  const float y = part < 0.5F ? row.min.y : row.max.y;
  ui.Fill(list, {{row.min.x + 8 * ui.scale, y - ui.scale}, {row.max.x, y + ui.scale}}, color);
}

}  // namespace

DropTarget OutlineTarget(const Scene& scene, std::uint32_t node, float part) {
  const SceneNode& at = scene.nodes[node];
  DropTarget target;
  const bool among = at.parent != kNoSceneNode && (part < kEdge || part > 1 - kEdge);
  target.place = among ? DropPlace::kGap : DropPlace::kNode;
  target.node = among ? at.parent : node;
  if (among) target.index = part < kEdge ? at.number - 1 : at.number;
  return target;
}

void DropOntoRow(const Ui& ui, EditorState& state, std::uint32_t node, const Box& row) {
  const ImGuiIO& io = ImGui::GetIO();
  const Point mouse = FromIm(io.MousePos);
  const bool is_over = state.drag.carried && row.Contains(mouse) &&
                       ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (!is_over || !state.workspace.view()) return;
  const Scene& scene = *state.workspace.view()->scene();
  const float part = (mouse.y - row.min.y) / row.height();
  const DropRequest request = {OutlineTarget(scene, node, part), io.KeyShift, io.KeyAlt};
  const NodeDrop drop(state, ui.now);
  const std::string refusal = drop.handler().why_not(*state.drag.carried, request);
  PaintTarget(ui, request.target, part, row,
              refusal.empty() ? ui.palette.accent : ui.palette.error);
  if (!refusal.empty()) Tooltip(ui, refusal);
  if (ImGui::IsMouseReleased(0) && refusal.empty())
    drop.handler().drop(*state.drag.carried, request);
}

}  // namespace coppice::editor
