#include "editor/panels/inspector/pages.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

constexpr char kHint[] = "Name, ports and guards of a node. Click one, or use the arrow keys.";

// A type is edited till another node is selected.
bool ShowsType(EditorState& state, const TreeView& view) {
  InspectorTile& tile = state.inspector;
  if (tile.node != view.selected() || !state.workspace.file()) tile.type.clear();
  return !tile.type.empty();
}

}  // namespace

bool ActionRow(const Ui& ui, const std::string& path, std::string_view words) {
  const Row row = NextRow(ui, path, false, 24);
  if (row.visible) {
    ui.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{8 * ui.scale, 0}, row.box.height(),
               words, {Face::kSans, 11, row.hovered ? ui.palette.text : ui.palette.text_dim},
               row.box.width() - 16 * ui.scale);
  }
  return row.clicked;
}

void DrawInspector(const Ui& ui, EditorState& state, const Box& box) {
  const TreeView* view = state.workspace.view();
  const bool has = view && view->selected() != kNoSceneNode;
  const bool is_type = view && ShowsType(state, *view);
  const std::string note = is_type ? "type " + state.inspector.type
                           : has   ? std::string(view->scene()->nodes[view->selected()].name)
                                   : "";
  Panel(ui, "inspector", box, "INSPECTOR", note, [&] {
    if (is_type) return DrawTypePage(ui, state);
    if (has) return DrawNodePage(ui, state);
    if (!view) return Hint(ui, "Name, ports and guards of the selected node.");
    if (state.workspace.file()) DrawTreePage(ui, state);
    Hint(ui, kHint);
  });
}

}  // namespace coppice::editor
