#include "editor/panels/panel.h"

#include <algorithm>

namespace coppice::editor {

void Panel(const Ui& ui, const std::string& path, const Box& box, std::string_view title,
           std::string_view note, const std::function<void()>& body) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float header = kPanelHeader * ui.scale;
  ui.items.Add(path, box);
  ui.Fill(list, box, ui.palette.panel, 4);
  list.AddRectFilled(ToIm(box.min), {box.max.x, box.min.y + header}, ui.palette.header, 4,
                     ImDrawFlags_RoundCornersTop);
  ui.Frame(list, box, ui.palette.border, 4);
  const float pad = 8 * ui.scale;
  const float used = ui.RowText(list, box.min + Point{pad, 0}, header, title,
                                {Face::kBold, 11, ui.palette.text}, box.width() - 2 * pad);
  const TextStyle small{Face::kSans, 11, ui.palette.text_dim};
  const float width = ui.Width(note, small);
  const float room = box.width() - 3 * pad - used;
  ui.RowText(list, {box.max.x - pad - std::min(width, room), box.min.y}, header, note, small, room);
  ImGui::SetCursorScreenPos({box.min.x + 1, box.min.y + header});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  const Point size = {box.width() - 2, box.height() - header - 2};
  if (size.x > 1 && size.y > 1) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild(path.c_str(), ToIm(size), false);
    ImGui::PopStyleVar();  // tooltips and menus of the body have theirs
    body();
    ImGui::EndChild();
  }
  ImGui::PopStyleVar();
}

Row NextRow(const Ui& ui, const std::string& path, bool selected, float height) {
  Row row;
  const Point at = FromIm(ImGui::GetCursorScreenPos());
  row.box = {at, at + Point{ImGui::GetContentRegionAvail().x, height * ui.scale}};
  ImGui::PushID(path.c_str());
  row.clicked = ImGui::InvisibleButton("row", {std::max(row.box.width(), 1.0F), row.box.height()});
  ImGui::PopID();
  row.hovered = ImGui::IsItemHovered();
  row.visible = ImGui::IsItemVisible();
  if (!row.visible) return row;
  ui.items.Add(path, row.box);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (selected) ui.Fill(list, row.box, ui.palette.row_selected);
  if (row.hovered && !selected) ui.Fill(list, row.box, ui.palette.row_hover);
  return row;
}

void Hint(const Ui& ui, std::string_view text) {
  ImGui::SetCursorPos({8 * ui.scale, ImGui::GetCursorPosY() + 6 * ui.scale});
  ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.text_dim);
  ImGui::PushTextWrapPos(ImGui::GetWindowWidth() - 8 * ui.scale);
  ImGui::PushFont(ui.fonts.Pick(Face::kSans, 12 * ui.scale));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

float Splitter(const Ui& ui, const std::string& path, const Box& box, bool vertical) {
  bool hovered = false;
  ui.Hit(path, box, &hovered);
  const bool active = ImGui::IsItemActive();
  if (hovered || active) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ui.Fill(*ImGui::GetWindowDrawList(), box, Fade(ui.palette.accent, 0.5F), 2);
  }
  if (!active) return 0;
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  return (vertical ? moved.x : moved.y) / ui.scale;
}

}  // namespace coppice::editor
