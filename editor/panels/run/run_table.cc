#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "editor/live/key_item.h"
#include "editor/live/values/value_cache.h"
#include "editor/live/values/value_table.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

constexpr float kCellPad = 8;
constexpr float kWidest = 320;  // pixels of a column at scale 1, but for the last one

Color ColorOf(const Palette& palette, const std::string& word) {
  switch (LevelOf(word)) {
    case CellLevel::kOff:
      return palette.text_dim;
    case CellLevel::kGood:
      return palette.success_text;
    case CellLevel::kBusy:
      return palette.running_text;
    case CellLevel::kWarning:
      return palette.warning;
    case CellLevel::kBad:
      return palette.error;
    case CellLevel::kNone:
      break;
  }
  return palette.text;
}

// The keys with tables at the shown moment.
std::vector<SlotIndex> TablesOf(const RunView& run) {
  std::vector<SlotIndex> tables;
  const std::vector<DescribedSlot>& slots = run.tree()->description()->slots;
  const std::vector<std::string>& values = run.follower().values();
  for (SlotIndex slot{0}; slot < std::min(slots.size(), values.size()); ++slot) {
    if (slots[slot].has_key && LooksLikeTable(values[slot])) tables.push_back(slot);
  }
  return tables;
}

class Table {
 public:
  Table(const Ui& ui, EditorState& state, ValueTable table)
      : ui_(ui), sort_(state.run.table_sort), table_(std::move(table)) {
    const auto column = std::find(table_.columns.begin(), table_.columns.end(), sort_.column);
    if (column != table_.columns.end()) {
      table_.Sort(static_cast<std::size_t>(column - table_.columns.begin()), sort_.descending);
    }
    for (std::size_t i = 0; i < table_.columns.size(); ++i) widths_.push_back(WidthOf(i));
  }

  void Draw() {
    DrawHead();
    for (std::size_t i = 0; i < table_.rows.size(); ++i) DrawRow(i);
  }

 private:
  float WidthOf(std::size_t column) const {
    float width = ui_.Width(table_.columns[column] + " ^", {Face::kBold, 11, 0});
    for (const auto& row : table_.rows) {
      width = std::max(width, ui_.Width(row[column].text, {Face::kSans, 12, 0}));
    }
    const bool is_last = column + 1 == table_.columns.size();
    return (is_last ? width : std::min(width, kWidest * ui_.scale)) + 2 * kCellPad * ui_.scale;
  }

  // They stand at the right end of their column, and so does its name.
  bool HoldsNumbers(std::size_t column) const {
    return !table_.rows.empty() &&
           std::all_of(table_.rows.begin(), table_.rows.end(),
                       [column](const auto& row) { return row[column].number.has_value(); });
  }

  void DrawHead() {
    const Row row = NextRow(ui_, "run/table/head", false);
    ImGui::SetItemAllowOverlap();
    if (!row.visible) return;
    const ImVec2 behind = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, row.box, Fade(ui_.palette.header, 0.6F));
    float x = row.box.min.x;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const std::string& name = table_.columns[i];
      const Box at = {{x, row.box.min.y}, {std::min(x + widths_[i], row.box.max.x), row.box.max.y}};
      x += widths_[i];
      if (at.width() <= kCellPad * ui_.scale) break;
      const bool sorted = sort_.column == name;
      if (ui_.Hit("run/table/sort/" + name, at)) {
        sort_.descending = sorted && !sort_.descending;
        sort_.column = name;
      }
      const std::string text = name + (sorted ? (sort_.descending ? " v" : " ^") : "");
      const TextStyle style{Face::kBold, 11, sorted ? ui_.palette.text : ui_.palette.text_dim};
      const float pad = kCellPad * ui_.scale;
      const float right = at.min.x + widths_[i] - pad - ui_.Width(text, style);
      const float left = HoldsNumbers(i) ? std::max(right, at.min.x + pad) : at.min.x + pad;
      ui_.RowText(list, {left, at.min.y}, at.height(), text, style, at.max.x - left);
    }
    ImGui::SetCursorScreenPos(behind);
  }

  void DrawRow(std::size_t number) {
    const Row row = NextRow(ui_, "run/table/" + std::to_string(number), false);
    const auto& cells = table_.rows[number];
    if (row.hovered) ImGui::SetTooltip("%s", Everything(cells).c_str());
    if (!row.visible) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float x = row.box.min.x;
    for (std::size_t i = 0; i < cells.size() && x < row.box.max.x; ++i) {
      const float pad = kCellPad * ui_.scale;
      const float room = std::min(widths_[i], row.box.max.x - x) - pad;
      const TextStyle style{Face::kSans, 12, ColorOf(ui_.palette, cells[i].text)};
      const float left = cells[i].number
                             ? std::max(x + widths_[i] - pad - ui_.Width(cells[i].text, style), x)
                             : x + pad;
      if (room > pad)
        ui_.RowText(list, {left, row.box.min.y}, row.box.height(), cells[i].text, style, room);
      x += widths_[i];
    }
  }

  std::string Everything(const std::vector<ValueTable::Cell>& cells) const {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].text.empty()) continue;
      text += (text.empty() ? "" : "\n") + table_.columns[i] + ": " + cells[i].text;
    }
    return text;
  }

  const Ui& ui_;
  TableSort& sort_;
  ValueTable table_;
  std::vector<float> widths_;
};

}  // namespace

void DrawTable(const Ui& ui, EditorState& state, RunView& run) {
  const std::vector<DescribedSlot>& slots = run.tree()->description()->slots;
  const std::vector<SlotIndex> tables = TablesOf(run);
  if (tables.empty()) {
    return Hint(ui, "No key holds a table (a list of objects) at this moment.");
  }
  const auto shown = std::find_if(tables.begin(), tables.end(), [&](SlotIndex slot) {
    return ItemOfKey(slots[slot]) == state.blackboard.shown_key;
  });
  const SlotIndex slot = shown == tables.end() ? tables.front() : *shown;
  if (tables.size() > 1) {
    const Row row = NextRow(ui, "run/table/keys", false);
    ImGui::SetItemAllowOverlap();
    const ImVec2 behind = ImGui::GetCursorScreenPos();
    float x = row.box.min.x + 4 * ui.scale;
    for (const SlotIndex other : tables) {
      const float width = ui.Width(slots[other].name, {Face::kSans, 12, 0}) + 14 * ui.scale;
      const Box at = {{x, row.box.min.y + ui.scale}, {x + width, row.box.max.y - ui.scale}};
      if (at.max.x > row.box.max.x) break;
      if (row.visible && ui.Button("run/table/key/" + slots[other].scope + "/" + slots[other].name,
                                   at, slots[other].name, other == slot)) {
        state.blackboard.shown_key = ItemOfKey(slots[other]);
      }
      x += width + 3 * ui.scale;
    }
    ImGui::SetCursorScreenPos(behind);
  }
  SlotView& view = CacheFor(state.blackboard.values, run)
                       .Of(ItemOfKey(slots[slot]), run.follower().values()[slot]);
  if (const ValueTable* const table = view.table()) Table(ui, state, *table).Draw();
}

}  // namespace coppice::editor
