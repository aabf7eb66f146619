#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <algorithm>

#include "bt_core/data/value_bytes.h"
#include "editor/canvas/layout/node_metrics.h"
#include "editor/commands/menus.h"
#include "editor/live/key_item.h"
#include "editor/live/values/value_cache.h"
#include "editor/live/values/value_table.h"
#include "editor/panels/panels.h"
#include "editor/panels/run/run_text.h"
#include "editor/panels/value_tree.h"
#include "editor/panels/widgets/panel.h"
#include "editor/timeline/slot_history.h"

namespace coppice::editor {
namespace {

constexpr double kFlashSeconds = 1.0;
constexpr float kPad = 8;  // pixels at scale 1
constexpr std::size_t kListedWrites = 6;
constexpr std::size_t kSamples = 120;
constexpr char kTableMark[] = "(table)";
constexpr std::size_t kSearchedKeys = 8;    // from so many on there is a field to search them
constexpr std::size_t kShownBytes = 160;    // of a value in its row
constexpr std::size_t kTooltipBytes = 600;  // copying gives the whole value
constexpr std::size_t kReadBytes = 65536;   // larger ones are read when they are opened
constexpr float kSearch = 26;               // height at scale 1

// Keys that the selected node's ports name.
std::vector<std::string> KeysOfSelection(const TreeView* view) {
  std::vector<std::string> keys;
  if (!view || view->selected() == kNoSceneNode) return keys;
  const Scene& scene = *view->scene();
  const SceneNode& node = scene.nodes[view->selected()];
  for (std::uint32_t i = 0; i < node.port_count; ++i) {
    const PortLine& port = scene.ports[node.first_port + i];
    if (!port.key.empty()) keys.emplace_back(port.key);
  }
  return keys;
}

std::string ScopeOfSelection(const TreeView* view) {
  if (!view || view->selected() == kNoSceneNode) return {};
  const Scene& scene = *view->scene();
  const SceneNode& node = scene.nodes[view->selected()];
  return node.scope < scene.scopes.size() ? scene.scopes[node.scope] : std::string();
}

class Board {
 public:
  Board(const Ui& ui, EditorState& state, RunView& run, const Box& box)
      : ui_(ui),
        state_(state),
        run_(run),
        tracks_(run.run().TracksAt(run.playhead().is_at_now() ? run.run().size()
                                                              : run.playhead().tick())),
        slots_(tracks_.tree()->slots),
        keys_(KeysOfSelection(state.workspace.view())),
        scope_(ScopeOfSelection(state.workspace.view())),
        cache_(CacheFor(state.blackboard.values, run)),
        width_(box.width()) {}

  void Draw() {
    DrawSearch();
    ListSlots();
    if (listed_.empty()) {
      Hint(ui_, !state_.blackboard.words.empty() ? "No key or value contains that."
                : state_.blackboard.selected_keys_only
                    ? "The selected node has no keys; B shows those of all nodes."
                    : "No key has a value yet.");
      return;
    }
    MeasureColumn();
    const std::string* scope = nullptr;
    for (const SlotIndex slot : listed_) {
      if (!scope || *scope != slots_[slot].scope) DrawScope(slots_[slot].scope);
      scope = &slots_[slot].scope;
      DrawSlot(slot);
    }
  }

  std::size_t CountKeys() const {
    return static_cast<std::size_t>(std::count_if(
        slots_.begin(), slots_.end(), [](const DescribedSlot& slot) { return slot.has_key; }));
  }

 private:
  // In the node's own blackboard if it has such a key, else wherever it is.
  bool IsOfSelection(SlotIndex slot) const {
    const DescribedSlot& described = slots_[slot];
    if (std::find(keys_.begin(), keys_.end(), described.name) == keys_.end()) return false;
    if (described.scope == scope_) return true;
    return std::none_of(slots_.begin(), slots_.end(), [&](const DescribedSlot& other) {
      return other.has_key && other.scope == scope_ && other.name == described.name;
    });
  }

  bool HasLargeValue() const {
    const auto& values = run_.follower().values();
    return std::any_of(values.begin(), values.end(),
                       [](const std::string& bytes) { return bytes.size() > kTooltipBytes; });
  }

  void DrawSearch() {
    std::string& words = state_.blackboard.words;
    if (words.empty() && CountKeys() < kSearchedKeys && !HasLargeValue()) return;
    ImGui::SetCursorPos({6 * ui_.scale, 4 * ui_.scale});
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 6 * ui_.scale);
    ImGui::PushFont(ui_.fonts.For(words, Face::kSans, 12 * ui_.scale));
    ImGui::InputTextWithHint("##search", "search keys and values", &words);
    ui_.items.Add("blackboard/search",
                  {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
    ImGui::PopFont();
    ImGui::SetCursorPos({0, (kSearch + 2) * ui_.scale});
  }

  const std::string& Bytes(SlotIndex slot) const {
    static const std::string kNothing;
    const auto& values = run_.follower().values();
    return slot < values.size() ? values[slot] : kNothing;
  }

  SlotView& View(SlotIndex slot) const { return cache_.Of(ItemOfKey(slots_[slot]), Bytes(slot)); }

  // Of a list or an object its size and how it begins.
  std::string ShownBeginning(SlotIndex slot) const {
    const std::string value = PrintBeginning(Bytes(slot), kShownBytes);
    const std::string_view text = TextOfBytes(Bytes(slot));
    const bool may_open = !text.empty() && (text[0] == '[' || text[0] == '{');
    if (!may_open || text.size() > kReadBytes) return value;
    const ValueRows* const rows = View(slot).rows();
    return rows && rows->rows[0].count > ValueRows::kFew ? SizeText(rows->rows[0]) + " " + value
                                                         : value;
  }

  bool IsFound(SlotIndex slot) const {
    const std::string& words = state_.blackboard.words;
    return words.empty() || View(slot).IsFound(slots_[slot].scope + "/" + slots_[slot].name, words);
  }

  void ListSlots() {
    for (SlotIndex i{0}; i < slots_.size(); ++i) {
      if (!slots_[i].has_key) continue;
      if (state_.blackboard.selected_keys_only && !IsOfSelection(i)) continue;
      if (IsFound(i)) listed_.push_back(i);
    }
    std::stable_sort(listed_.begin(), listed_.end(), [this](SlotIndex a, SlotIndex b) {
      return slots_[a].scope < slots_[b].scope;
    });
  }

  void MeasureColumn() {
    column_ = 60 * ui_.scale;
    for (const SlotIndex slot : listed_) {
      column_ = std::max(column_, ui_.Width(slots_[slot].name, {Face::kBold, 12, 0}));
    }
    column_ = std::min(column_ + 14 * ui_.scale, width_ * 0.45F);
  }

  void DrawScope(const std::string& scope) {
    const Row row = NextRow(ui_, "blackboard/" + scope, false);
    if (!row.visible) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, row.box, Fade(ui_.palette.header, 0.6F));
    ui_.RowText(list, row.box.min + Point{8 * ui_.scale, 0}, row.box.height(), scope,
                {Face::kBold, 11, ui_.palette.text_dim}, row.box.width() - 16 * ui_.scale);
  }

  const SlotWrite* LastWrite(SlotIndex slot) const {
    return run_.run().size() == 0 ? nullptr : LastWriteOf(run_.run(), slot, run_.playhead().tick());
  }

  bool IsTable(SlotIndex slot) const { return LooksLikeTable(Bytes(slot)); }

  bool IsWaiting(SlotIndex slot) const { return state_.blackboard.writes.IsWaiting(run_, slot); }

  void DrawSlot(SlotIndex slot) {
    const DescribedSlot& described = slots_[slot];
    const std::string path = ItemOfKey(described);
    const bool selected = state_.blackboard.shown_key == path;
    const Row row = NextRow(ui_, path, selected);
    const bool is_table = IsTable(slot);
    const std::string value = is_table ? kTableMark : ShownBeginning(slot);
    const SlotWrite* write = LastWrite(slot);
    if (row.hovered) {
      const std::string by = write ? "\nwritten in " + TickText(run_.run(), write->tick) + " by " +
                                         WriterOf(run_.run(), *write)
                                   : "";
      if (selected) {  // above it, for below it are the curve and the writes
        ImGui::SetNextWindowPos({row.box.min.x, row.box.min.y - 4 * ui_.scale}, ImGuiCond_Always,
                                {0, 1});
      }
      Tooltip(ui_, described.name + " : " + std::string(TypeText(described.type)) + "\n" +
                       PrintBeginning(Bytes(slot), kTooltipBytes) + by +
                       "\nClick to see its writes, double-click to write it.");
      if (ImGui::IsMouseDoubleClicked(0)) state_.commands.Run("blackboard.write");
    }
    if (row.clicked) state_.blackboard.shown_key = path;
    if (row.right_clicked) {
      state_.blackboard.shown_key = path;
      OpenMenu(state_, menu::kKey, FromIm(ImGui::GetIO().MousePos));
    }
    if (row.clicked && is_table) state_.run.tab = RunTab::kTable;
    if (row.visible) PaintSlot(row.box, slot, value, write);
    const bool is_only_one = !state_.blackboard.words.empty() && listed_.size() == 1;
    if (selected || is_only_one) DrawValueTree(ui_, View(slot), state_.blackboard.words);
    if (selected) DrawHistory(slot);
  }

  void PaintSlot(const Box& box, SlotIndex slot, const std::string& value,
                 const SlotWrite* write) const {
    const DescribedSlot& described = slots_[slot];
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (write) {
      const Duration age = run_.state().now - run_.run().TimeOf(write->tick);
      const double part = static_cast<double>(age.count()) * 1e-9 / kFlashSeconds;
      if (part < 1) {
        const auto left = static_cast<float>(1 - std::max(part, 0.0));
        ui_.Fill(list, box, Fade(ui_.palette.accent, 0.15F * left * left));
      }
    }
    const float pad = 8 * ui_.scale;
    ui_.RowText(
        list, box.min + Point{pad, 0}, box.height(), described.name,
        {IsOfSelection(slot) ? Face::kBold : Face::kSans, 12, ui_.palette.OfKey(described.name)},
        column_ - pad);
    if (IsOfSelection(slot)) {
      ui_.Fill(list, {box.min, {box.min.x + 3 * ui_.scale, box.max.y}}, ui_.palette.accent);
    }
    const bool unset = value.empty();
    const float room = box.width() - column_ - 2 * pad;
    const float used =
        ui_.RowText(list, box.min + Point{pad + column_, 0}, box.height(),
                    unset ? "(unset)" : ShownValue(ShortNumber(value)),
                    {Face::kMono, 11, unset ? ui_.palette.text_dim : ui_.palette.text}, room);
    if (IsWaiting(slot)) return PaintWaiting(box, slot);
    if (!write || room - used < 50 * ui_.scale) return;
    const std::string by = WriterOf(run_.run(), *write);
    const std::string name = by.substr(by.rfind('/') + 1);
    const TextStyle dim{Face::kSans, 10, ui_.palette.text_dim};
    const float width = std::min(ui_.Width(name, dim), room - used - pad);
    ui_.RowText(list, {box.max.x - pad - width, box.min.y}, box.height(), name, dim, width + 1);
  }

  // What was written is not the value yet.
  void PaintWaiting(const Box& box, SlotIndex slot) const {
    static constexpr char kText[] = "waits for the next tick";
    const TextStyle style{Face::kSans, 10, ui_.palette.accent};
    const float width = std::min(ui_.Width(kText, style), box.width() - column_);
    const Box at = {{box.max.x - kPad * ui_.scale - width, box.min.y}, box.max};
    ui_.RowText(*ImGui::GetWindowDrawList(), at.min, box.height(), kText, style, width + 1);
    ui_.items.Add("blackboard/waiting/" + slots_[slot].scope + "/" + slots_[slot].name, at);
  }

  // Below the key that was clicked: its curve if it is a number, and its last writes.
  void DrawHistory(SlotIndex slot) {
    const auto& writes = tracks_.WritesOf(slot);
    const std::size_t count = WritesUpTo(writes, run_.playhead().tick());
    DrawCurve(slot);
    for (std::size_t i = 0; i < std::min(count, kListedWrites); ++i) {
      DrawWrite(writes[count - 1 - i], i);
    }
    if (count > kListedWrites) {
      const Row row = NextRow(ui_, "blackboard/more", false);
      ui_.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{2 * kPad * ui_.scale, 0},
                  row.box.height(), "and " + Count(count - kListedWrites, "write") + " before",
                  {Face::kSans, 11, ui_.palette.text_dim});
    }
  }

  void DrawWrite(const SlotWrite& write, std::size_t number) {
    const Row row = NextRow(ui_, "blackboard/write/" + std::to_string(number), false);
    if (row.hovered) Tooltip(ui_, "Click to go to this tick.");
    if (row.clicked) run_.playhead().GoToTick(write.tick);
    if (!row.visible) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = kPad * ui_.scale;
    const TextStyle dim{Face::kSans, 11, ui_.palette.text_dim};
    ui_.RowText(list, row.box.min + Point{2 * pad, 0}, row.box.height(),
                AxisText(run_.run().TimeOf(write.tick)), dim, column_ - 2 * pad);
    const float room = row.box.width() - column_ - 2 * pad;
    const float used = ui_.RowText(list, row.box.min + Point{pad + column_, 0}, row.box.height(),
                                   ShortNumber(ValueOf(run_.run(), write)),
                                   {Face::kMono, 11, ui_.palette.text}, room * 0.5F);
    ui_.RowText(list, row.box.min + Point{2 * pad + column_ + used, 0}, row.box.height(),
                WriterOf(run_.run(), write), dim, room - used - pad);
  }

  void DrawCurve(SlotIndex slot) {
    const std::size_t end = run_.playhead().tick() + 1;
    const std::size_t first = run_.run().SectionAt(end - 1).tree == run_.run().SectionAt(0).tree
                                  ? 0
                                  : end - std::min(end, kSamples);
    std::vector<std::size_t> ticks;
    const std::size_t count = std::min(end - first, kSamples);
    for (std::size_t i = 1; i <= count; ++i) ticks.push_back(first + (end - first) * i / count - 1);
    const auto samples = SampleSlot(run_.run(), slot, ticks);
    const Row row = NextRow(ui_, "blackboard/curve", false, 40);
    if (row.visible) PaintCurve(ui_, *ImGui::GetWindowDrawList(), row.box, samples);
  }

  const Ui& ui_;
  EditorState& state_;
  RunView& run_;
  const Tracks& tracks_;
  const std::vector<DescribedSlot>& slots_;
  const std::vector<std::string> keys_;
  const std::string scope_;  // of the selected node
  ValueCache& cache_;
  const float width_;
  std::vector<SlotIndex> listed_;
  float column_ = 0;
};

}  // namespace

void DrawBlackboard(const Ui& ui, EditorState& state, const Box& box) {
  RunView* run = state.workspace.run();
  if (!run || !run->tree()) {
    Panel(ui, "blackboard", box, "BLACKBOARD", "", [&] {
      Hint(ui,
           "The values of a running tree. Ctrl+K connects to a robot, Ctrl+O opens a record, "
           "F5 simulates the shown tree.");
    });
    return;
  }
  Board board(ui, state, *run, box);
  const std::string note =
      state.blackboard.selected_keys_only ? "of the selection" : Count(board.CountKeys(), "key");
  Panel(ui, "blackboard", box, "BLACKBOARD", note, [&] { board.Draw(); });
}

}  // namespace coppice::editor
