#include <cmath>

#include "editor/panels/panels.h"

namespace coppice::editor {
namespace {

std::string Breadcrumb(EditorState& state) {
  const Workspace& workspace = state.workspace;
  std::string text;
  if (const OpenFile* file = workspace.file()) text = file->path.substr(file->path.rfind('/') + 1);
  if (const RunView* run = workspace.run()) text = run->name();
  TreeView* view = state.workspace.view();
  if (!view) return text;
  text += "  /  " + view->scene()->tree_id;
  if (view->selected() == kNoNode) return text;
  const auto& nodes = view->scene()->nodes;
  std::string inner;
  for (std::uint32_t i = view->selected(); i != kNoNode; i = nodes[i].parent) {
    if (i == view->selected() || nodes[i].shape == Shape::kSubTree) {
      inner = "  /  " + std::string(nodes[i].name) + inner;
    }
  }
  return text + inner;
}

}  // namespace

void DrawCanvasBar(const Ui& ui, EditorState& state, const Box& box) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ToIm(box.min), ToIm(box.max), ui.palette.header, 4,
                     ImDrawFlags_RoundCornersTop);
  float x = box.max.x - 6 * ui.scale;
  const auto button = [&](const std::string& path, const std::string& text, bool active) {
    const float width = ui.Width(text, {Face::kSans, 12, 0}) + 16 * ui.scale;
    const Box at = {{x - width, box.min.y + 3 * ui.scale}, {x, box.max.y - 3 * ui.scale}};
    x -= width + 4 * ui.scale;
    return ui.Button(path, at, text, active);
  };
  TreeView* view = state.workspace.view();
  const int percent =
      view ? static_cast<int>(std::lround(view->camera.zoom * 100 / view->screen_scale)) : 100;
  const bool sideways = state.workspace.orientation() == Orientation::kLeftToRight;
  if (button("canvasbar/zoom", std::to_string(percent) + " %", false)) {
    state.commands.Run("view.zoom_100");
  }
  if (button("canvasbar/fit", "fit", false)) state.commands.Run("view.fit_all");
  if (button("canvasbar/lr", "LR", sideways)) state.commands.Run("view.left_to_right");
  if (button("canvasbar/tb", "TB", !sideways)) state.commands.Run("view.top_to_bottom");
  const float left = box.min.x + 10 * ui.scale;
  ui.RowText(list, {left, box.min.y}, box.height(), Breadcrumb(state),
             {Face::kSans, 12, ui.palette.text}, x - left - 8 * ui.scale);
}

}  // namespace coppice::editor
