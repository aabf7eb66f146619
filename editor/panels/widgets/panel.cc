#include "editor/panels/widgets/panel.h"

#include <algorithm>
#include <cmath>

namespace coppice::editor {
namespace {

constexpr float kTooltipWidth = 420;  // at most
constexpr float kLeastNote = 24;      // of a note that is shortened, or it is left out

}  // namespace

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
  if (room >= std::min(width, kLeastNote * ui.scale)) {
    ui.RowText(list, {box.max.x - pad - std::min(width, room), box.min.y}, header, note, small,
               room);
  }
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
  row.right_clicked = row.hovered && ImGui::IsMouseReleased(1);
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
  ImGui::PushFont(ui.fonts.For(text, Face::kSans, 12 * ui.scale));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

Row TextRow(const Ui& ui, const std::string& path, std::string_view text, const TextStyle& style) {
  const float pad = 8 * ui.scale;
  const float width = ImGui::GetContentRegionAvail().x - 2 * pad;
  const float height = ui.ParagraphHeight(text, style, width);
  const float room = std::max(height + 7 * ui.scale, kRowHeight * ui.scale);
  const Row row = NextRow(ui, path, false, room / ui.scale);
  if (row.visible) {
    const Point at = {row.box.min.x + pad, row.box.center().y - height / 2};
    ui.Paragraph(*ImGui::GetWindowDrawList(), at, text, style, width);
  }
  return row;
}

void Tooltip(const Ui& ui, std::string_view text) {
  const float pad = 8 * ui.scale;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, 0.75F * pad});
  ImGui::BeginTooltip();
  ImGui::PushFont(ui.fonts.For(text, Face::kSans, 12 * ui.scale));
  ImGui::PushTextWrapPos(kTooltipWidth * ui.scale);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void ExplainCommand(const Ui& ui, const CommandTable& commands, std::string_view id) {
  if (!ImGui::IsItemHovered()) return;
  const EditorCommand* command = commands.Find(id);
  if (!command) return;
  const std::string keys = ToString(command->keys);
  Tooltip(ui, keys.empty() ? command->title : command->title + "   " + keys);
}

MenuSpacing::MenuSpacing(const Ui& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * ui.scale, 6 * ui.scale});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * ui.scale, 8 * ui.scale});
}

MenuSpacing::~MenuSpacing() { ImGui::PopStyleVar(2); }

std::string InOneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!blank) line += c;
    if (blank && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

std::string Count(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
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
