#include "editor/panels/value_tree.h"

#include <imgui.h>

#include <algorithm>
#include <optional>

#include "editor/live/key_search.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kMostShown = 100'000;  // beyond, a float no longer tells one pixel from two
constexpr std::size_t kShownBytes = 160;     // of a value, in a row
constexpr std::size_t kTooltipBytes = 600;
constexpr float kIndent = 12;  // pixels at scale 1
constexpr float kLeft = 14;
constexpr float kMark = 14;

void PaintRow(const Ui& ui, SlotView& view, std::uint32_t number, const Box& box) {
  const ValueRows& rows = *view.rows();
  const ValueRow& row = rows.rows[number];
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto depth = static_cast<float>(row.depth - 1);
  float x = box.min.x + std::min((kLeft + kIndent * depth) * ui.scale, box.width() * 0.5F);
  const float end = box.max.x - 6 * ui.scale;
  const TextStyle dim{Face::kSans, 11, ui.palette.text_dim};
  const bool is_open = view.IsRowOpen(number);
  if (row.count > 0) {
    ui.RowText(list, {x, box.min.y}, box.height(), is_open ? "-" : "+", dim, kMark * ui.scale);
  }
  x += kMark * ui.scale;
  const bool is_member = rows.rows[row.parent].kind == '{';
  const std::string name =
      is_member ? BeginningOf(rows.KeyOf(row), kShownBytes) : std::to_string(row.number);
  const TextStyle bold{Face::kBold, 11, is_member ? ui.palette.text : ui.palette.text_dim};
  x += ui.RowText(list, {x, box.min.y}, box.height(), name, bold, end - x) + 10 * ui.scale;
  if (x >= end) return;
  if (row.kind != 0) {
    x += ui.RowText(list, {x, box.min.y}, box.height(), SizeText(row), dim, end - x) + 8 * ui.scale;
    if (is_open || row.count == 0 || x >= end) return;
  }
  const std::string_view text = rows.TextOf(row);
  ui.RowText(list, {x, box.min.y}, box.height(), InOneLine(BeginningOf(text, kShownBytes)),
             {Face::kMono, 11, row.kind != 0 ? ui.palette.text_dim : ui.palette.text}, end - x);
}

}  // namespace

void DrawValueTree(const Ui& ui, SlotView& view, const std::string& words) {
  if (!view.rows()) return;
  const std::vector<std::uint32_t>& shown = view.Shown(words);
  const std::size_t count = std::min(shown.size(), kMostShown);
  std::optional<std::uint32_t> clicked;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), kRowHeight * ui.scale);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const std::uint32_t number = shown[static_cast<std::size_t>(i)];
      const ValueRows& rows = *view.rows();
      const Row row = NextRow(ui, "blackboard/value" + rows.PathOf(number), false);
      if (row.clicked) clicked = number;
      if (row.hovered) {
        Tooltip(ui, rows.PathOf(number) + "\n" +
                        BeginningOf(rows.TextOf(rows.rows[number]), kTooltipBytes));
      }
      if (row.visible) PaintRow(ui, view, number, row.box);
    }
  }
  if (shown.size() > count) {
    Hint(ui, "There are more rows than can be scrolled to: the search above finds within them.");
  }
  if (clicked) view.Turn(*clicked);
}

}  // namespace coppice::editor
