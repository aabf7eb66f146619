#include <algorithm>

#include "editor/canvas/node_metrics.h"
#include "editor/panels/panel.h"
#include "editor/panels/panels.h"

namespace coppice::editor {
namespace {

constexpr double kFlashSeconds = 1.0;

void DrawScope(const Ui& ui, const std::string& scope, std::size_t count) {
  const Row row = NextRow(ui, "blackboard/" + scope, false);
  if (!row.visible) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ui.Fill(list, row.box, Fade(ui.palette.header, 0.6F));
  ui.RowText(list, row.box.min + Point{8 * ui.scale, 0}, row.box.height(), scope,
             {Face::kBold, 11, ui.palette.text_dim}, row.box.width() - 60 * ui.scale);
  const std::string note = std::to_string(count);
  const TextStyle style{Face::kSans, 11, ui.palette.text_dim};
  ui.RowText(list, {row.box.max.x - 10 * ui.scale - ui.Width(note, style), row.box.min.y},
             row.box.height(), note, style);
}

void DrawValue(const Ui& ui, const std::string& scope, const std::string& key,
               const ShownValueState& value, float column, bool used) {
  const Row row = NextRow(ui, "blackboard/" + scope + "/" + key, used);
  if (row.hovered) ImGui::SetTooltip("%s = %s", key.c_str(), value.value.c_str());
  if (!row.visible) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double age = (ui.now - value.changed_at) / kFlashSeconds;
  if (age < 1) {
    const auto left = static_cast<float>(1 - age);
    ui.Fill(list, row.box, Fade(ui.palette.running, 0.35F * left * left));
  }
  const float pad = 8 * ui.scale;
  ui.RowText(list, row.box.min + Point{pad, 0}, row.box.height(), key,
             {Face::kSans, 12, ui.palette.OfKey(key)}, column - pad);
  const bool unset = value.value == "null";
  ui.RowText(list, row.box.min + Point{pad + column, 0}, row.box.height(),
             unset ? "(unset)" : ShownValue(value.value),
             {Face::kMono, 11, unset ? ui.palette.text_dim : ui.palette.text},
             row.box.width() - column - 2 * pad);
}

// Keys that the selected node's ports name.
std::vector<std::string> KeysOfSelection(const TreeView* view) {
  std::vector<std::string> keys;
  if (!view || view->selected() == kNoNode) return keys;
  const Scene& scene = *view->scene();
  const SceneNode& node = scene.nodes[view->selected()];
  for (std::uint32_t i = 0; i < node.port_count; ++i) {
    const PortLine& port = scene.ports[node.first_port + i];
    if (port.is_key) keys.emplace_back(KeyOf(port.value));
  }
  return keys;
}

float KeyColumn(const Ui& ui, const BoardHistory& boards, float width) {
  float column = 60 * ui.scale;
  for (const auto& [scope, values] : boards) {
    for (const auto& [key, value] : values) {
      column = std::max(column, ui.Width(key, {Face::kSans, 12, 0}));
    }
  }
  return std::min(column + 14 * ui.scale, width * 0.5F);
}

}  // namespace

void DrawBlackboard(const Ui& ui, EditorState& state, const Box& box) {
  const Robot* robot = state.workspace.robot();
  const TreeView* view = state.workspace.view();
  std::size_t count = 0;
  if (robot) {
    for (const auto& [scope, values] : robot->boards) count += values.size();
  }
  const std::string note = count ? std::to_string(count) + " keys" : "";
  Panel(ui, "blackboard", box, "BLACKBOARD", note, [&] {
    if (!robot) {
      Hint(ui, "Values are shown while connected to a robot.");
      return;
    }
    if (count == 0) {
      Hint(ui, "No values yet.");
      return;
    }
    const std::vector<std::string> keys = KeysOfSelection(view);
    const float column = KeyColumn(ui, robot->boards, box.width());
    const auto draw = [&](const std::string& scope) {
      const auto found = robot->boards.find(scope);
      if (found == robot->boards.end() || found->second.empty()) return;
      DrawScope(ui, scope, found->second.size());
      for (const auto& [key, value] : found->second) {
        const bool used = std::find(keys.begin(), keys.end(), key) != keys.end();
        DrawValue(ui, scope, key, value, column, used);
      }
    };
    if (!view) return;
    for (const std::string& scope : view->scene()->scopes) draw(scope);
    draw("ROOT");
  });
}

}  // namespace coppice::editor
