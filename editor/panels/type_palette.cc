// The tile of node types: what can be dragged onto the canvas.
#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "editor/canvas/layout/node_metrics.h"
#include "editor/keys/recent.h"
#include "editor/panels/drag_source.h"
#include "editor/panels/panels.h"
#include "editor/panels/popup/type_choices.h"
#include "editor/panels/widgets/panel.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

constexpr float kFilter = 26;

struct Kind {
  const char* name;
  Shape shape;
};
constexpr std::array<Kind, 6> kKinds = {{{"Control", Shape::kControl},
                                         {"Decorator", Shape::kDecorator},
                                         {"Action", Shape::kAction},
                                         {"Condition", Shape::kCondition},
                                         {"SubTree", Shape::kSubTree},
                                         {"unknown", Shape::kUnknown}}};

std::size_t KindOf(const TypeChoice& type) {
  std::size_t i = 0;
  while (i + 1 < kKinds.size() && type.kind != kKinds[i].name) ++i;
  return i;
}

void DrawFilter(const Ui& ui, EditorState& state) {
  ImGui::SetCursorPos({6 * ui.scale, 4 * ui.scale});
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 6 * ui.scale);
  ImGui::PushFont(ui.fonts.For(state.input.type_filter, Face::kSans, 12 * ui.scale));
  ImGui::InputTextWithHint("##filter", "filter", &state.input.type_filter);
  ui.items.Add("types/filter", {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
  ImGui::PopFont();
  ImGui::SetCursorPos({0, kFilter * ui.scale + 2 * ui.scale});
}

void DrawType(const Ui& ui, EditorState& state, const TypeChoice& type) {
  const Row row = NextRow(ui, "types/" + type.type, false);
  if (StartsDrag()) {
    state.drag.carried = Drag{{}, type.type};
    state.drag.xml = type.xml;
    state.drag.answer = {};
  }
  const bool twice = row.hovered && ImGui::IsMouseDoubleClicked(0);
  if (row.hovered && !type.note.empty() && !state.drag.carried) {
    Tooltip(ui, type.note);
  }
  if (row.visible) {
    const Shape shape = kKinds[KindOf(type)].shape;
    const std::string_view glyph = GlyphOf(shape, type.type);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const TextStyle style{Face::kSans, 12, Mix(ui.palette.Of(shape), ui.palette.text, 0.6F)};
    const float middle = row.box.min.x + 19 * ui.scale;
    ui.RowText(list, {middle - ui.Width(glyph, style) / 2, row.box.min.y}, row.box.height(), glyph,
               style);
    ui.RowText(list, row.box.min + Point{34 * ui.scale, 0}, row.box.height(), type.type,
               {Face::kSans, 12, ui.palette.text}, row.box.width() - 40 * ui.scale);
  }
  if (!twice) return;
  state.after_frame = [&state, type, now = ui.now] {
    if (TreeEditor(state, now).Add(type.xml, type.type, AddWhere::kChild)) {
      UseAgain(state.recent.types, type.type);
    }
  };
}

}  // namespace

void DrawTypes(const Ui& ui, EditorState& state, const Box& box) {
  std::vector<TypeChoice> types = FindTypes(state, state.input.type_filter, true, SIZE_MAX);
  if (state.input.type_filter.empty()) {
    std::stable_sort(types.begin(), types.end(), [](const auto& a, const auto& b) {
      return std::make_pair(KindOf(a), a.type) < std::make_pair(KindOf(b), b.type);
    });
  }
  const bool can_edit = state.workspace.file() && !state.workspace.run();
  Panel(ui, "types", box, "NODES", can_edit ? "drag onto the canvas" : "", [&] {
    if (!can_edit) {
      return Hint(ui, state.workspace.run()
                          ? "Runs cannot be edited. Click a tree in PROJECT to add nodes to it."
                          : "The node types that can be dragged onto the canvas. Ctrl+O opens a "
                            "file, Ctrl+N begins one.");
    }
    DrawFilter(ui, state);
    const std::string* heading = nullptr;
    for (const TypeChoice& type : types) {
      if (state.input.type_filter.empty() && (!heading || *heading != type.kind)) {
        const Row row = NextRow(ui, "types/heading/" + type.kind, false, 19);
        ui.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{8 * ui.scale, 0},
                   row.box.height(), type.kind, {Face::kBold, 11, ui.palette.text_dim});
        heading = &type.kind;
      }
      DrawType(ui, state, type);
    }
  });
}

}  // namespace coppice::editor
