#include "editor/panels/popup/popup_rows.h"

#include <algorithm>

#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

bool IsPressed(const EditorState& state, Key key) {
  return std::any_of(state.input.keys.begin(), state.input.keys.end(),
                     [key](const KeyEvent& event) { return event.key == key; });
}

}  // namespace

PopupRows::PopupRows(const Ui& ui, EditorState& state, std::size_t count, bool has_choice)
    : ui_(ui), state_(state), has_choice_(has_choice) {
  const int before = state.popup.choice;
  if (IsPressed(state, kKeyDown)) ++state.popup.choice;
  if (IsPressed(state, kKeyUp)) --state.popup.choice;
  const int last = std::max(static_cast<int>(count) - 1, 0);
  state.popup.choice = std::clamp(state.popup.choice, 0, last);
  choice_has_moved_ = state.popup.choice != before;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::Dummy({1, 6 * ui.scale});
  const std::size_t in_sight = std::clamp<std::size_t>(count, 1, kPopupRows);
  const float height = static_cast<float>(in_sight) * kRowHeight * ui.scale;
  ImGui::BeginChild("rows", {0, height}, false);
}

PopupRows::~PopupRows() {
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

bool PopupRows::Next(const std::string& title, const std::string& note, const std::string& kind) {
  const bool chosen = has_choice_ && next_ == state_.popup.choice;
  const Row row = NextRow(ui_, "popup/" + std::to_string(next_++), chosen);
  if (chosen && choice_has_moved_) ImGui::SetScrollHereY();
  if (row.visible) PaintPopupRow(ui_, row.box, title, note, kind);
  return row.clicked;
}

void PaintPopupRow(const Ui& ui, const Box& box, const std::string& title, const std::string& note,
                   const std::string& kind) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const TextStyle dim{Face::kSans, 11, ui.palette.text_dim};
  const TextStyle style{Face::kSans, 12, ui.palette.text};
  const float kind_width = 64 * ui.scale;
  const float pad = 6 * ui.scale;
  if (!kind.empty()) ui.RowText(list, box.min + Point{pad, 0}, box.height(), kind, dim);
  const float left = box.min.x + (kind.empty() ? pad : kind_width);
  const float rest = box.max.x - left - ui.Width(title, style) - 4 * pad;
  const float note_width = std::min(ui.Width(note, dim), std::max(box.width() * 0.4F, rest));
  ui.RowText(list, {left, box.min.y}, box.height(), title, style,
             box.max.x - left - note_width - 3 * pad);
  // The line of a place stands at its end, and the name of a file at that of its path.
  ui.RowText(list, {box.max.x - note_width - pad, box.min.y}, box.height(),
             ui.CutStart(note, dim, note_width + 1), dim);
}

}  // namespace coppice::editor
