#include "editor/panels/widgets/inspector_row.h"

#include <algorithm>

namespace coppice::editor {
namespace {

constexpr float kLabelWidth = 92;   // pixels at scale 1, at least
constexpr float kLabelPart = 0.3F;  // of a wide panel
constexpr float kPad = 8;
constexpr float kRow = 24;
constexpr float kHeading = 22;

float LabelWidth(const Ui& ui, const Box& row) {
  return std::max(kLabelWidth * ui.scale, kLabelPart * row.width());
}

void PaintLabel(const Ui& ui, const Box& row, std::string_view label) {
  ui.RowText(*ImGui::GetWindowDrawList(), row.min + Point{kPad * ui.scale, 0}, row.height(), label,
             {Face::kSans, 11, ui.palette.text_dim}, LabelWidth(ui, row) - 8 * ui.scale);
}

Box FieldOf(const Ui& ui, const Box& row) {
  return {row.min + Point{kPad * ui.scale + LabelWidth(ui, row), ui.scale},
          row.max - Point{kPad * ui.scale, ui.scale}};
}

}  // namespace

Row ValueRow(const Ui& ui, const std::string& path, std::string_view label, std::string_view value,
             const TextStyle& style) {
  const Row row = NextRow(ui, path, false, kRow);
  if (!row.visible) return row;
  PaintLabel(ui, row.box, label);
  const Box field = FieldOf(ui, row.box);
  ui.RowText(*ImGui::GetWindowDrawList(), field.min + Point{6 * ui.scale, 0}, field.height(), value,
             style, field.width() - 6 * ui.scale);
  return row;
}

FieldResult FieldRow(const Ui& ui, EditorState& state, const std::string& path,
                     const std::string& key, std::string_view label, const std::string& value,
                     const FieldLook& look, const std::string& problem) {
  const Point at = FromIm(ImGui::GetCursorScreenPos());
  const Box row = {at, at + Point{ImGui::GetContentRegionAvail().x, kRow * ui.scale}};
  PaintLabel(ui, row, label);
  const Box field = FieldOf(ui, row);
  const FieldResult result = DrawField(ui, state, path, key, field, value, look);
  if (!problem.empty()) {
    ui.Frame(*ImGui::GetWindowDrawList(), field, ui.palette.error, 3 * ui.scale, 1.5F * ui.scale);
    ui.items.Add(path + "/problem", field);
    const bool over = ImGui::IsMouseHoveringRect(ToIm(field.min), ToIm(field.max));
    if (over && ImGui::IsWindowHovered()) Tooltip(ui, problem);
  }
  ImGui::SetCursorScreenPos(ToIm(row.min));
  ImGui::Dummy({row.width(), row.height()});
  return result;
}

void HeadingRow(const Ui& ui, std::string_view text) {
  const Row row = NextRow(ui, "inspector/heading/" + std::string(text), false, kHeading);
  ui.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{kPad * ui.scale, 0}, row.box.height(),
             text, {Face::kBold, 11, ui.palette.text_dim});
}

}  // namespace coppice::editor
