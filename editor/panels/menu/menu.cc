// A window of the size of the screen takes the clicks beside the menus; each menu lies on it. One
// that is longer than the screen has a scrollbar.
#include "editor/panels/menu/menu.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "editor/commands/menus.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr float kEntry = 22;  // pixels at scale 1
constexpr float kLine = 9;
constexpr float kPad = 5;
constexpr float kMark = 24;     // room for the sign of a switch
constexpr float kBetween = 28;  // title and keys
constexpr float kWidest = 620;
constexpr ImGuiWindowFlags kFlags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

class Menus {
 public:
  Menus(const Ui& ui, EditorState& state)
      : ui_(ui), state_(state), mouse_(FromIm(ImGui::GetIO().MousePos)) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    mouse_moved_ = moved.x != 0 || moved.y != 0;
  }

  void Draw() {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("behind the menus", nullptr, kFlags | ImGuiWindowFlags_NoBackground);
    const bool is_new = ImGui::IsWindowAppearing();
    ImGui::End();
    for (std::size_t level = 0; level < state_.menu.open.size(); ++level) DrawMenu(level);
    const bool clicked = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1);
    if (!state_.menu.open.empty() && !is_new && clicked && !is_over_) state_.menu.open.clear();
    if (!state_.menu.open.empty() && mouse_moved_ && !is_over_) FollowBar();
  }

 private:
  TextStyle Style(Color color) const { return {Face::kSans, 12.5F, color}; }

  float Width(const std::vector<MenuItem>& items) const {
    float title = 0;
    float keys = 0;
    for (const MenuItem& item : items) {
      title = std::max(title, ui_.Width(item.title, Style(0)));
      keys = std::max(keys, ui_.Width(item.keys, Style(0)));
    }
    const float around = (2 * kPad + kMark + kBetween) * ui_.scale;
    return std::min(title + keys + around, kWidest * ui_.scale);
  }

  static float HeightOf(const MenuItem& item) { return item.is_line() ? kLine : kEntry; }

  // At its point, below its title, or beside the entry that opens it; and on the screen.
  Point Corner(std::size_t level, Point size) const {
    const OpenMenuState& menu = state_.menu.open[level];
    const Point screen = FromIm(ImGui::GetIO().DisplaySize);
    Point at = menu.at;
    if (const Box* const item = menu.below.empty() ? nullptr : ui_.items.Find(menu.below)) {
      const bool is_large = item->height() > screen.y / 3;
      at = level > 0  ? Point{item->max.x - kPad * ui_.scale, item->min.y - kPad * ui_.scale}
           : is_large ? item->center()
                      : Point{item->min.x, item->max.y};
    }
    return {std::clamp(at.x, 0.0F, std::max(screen.x - size.x, 0.0F)),
            std::clamp(at.y, 0.0F, std::max(screen.y - size.y, 0.0F))};
  }

  void DrawMenu(std::size_t level) {
    const std::vector<MenuItem> items = ItemsOf(state_, state_.menu.open[level].name);
    if (items.empty()) return state_.menu.open.resize(level);
    float height = 2 * kPad;
    for (const MenuItem& item : items) height += HeightOf(item);
    const float screen = ImGui::GetIO().DisplaySize.y;
    const bool is_long = height * ui_.scale > screen;
    const float bar = is_long ? ImGui::GetStyle().ScrollbarSize : 0;
    const Point size = {Width(items) + bar, std::min(height * ui_.scale, screen)};
    const Point at = Corner(level, size);
    ImGui::SetNextWindowPos(ToIm(at));
    ImGui::SetNextWindowSize(ToIm(size));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ui_.palette.panel);
    ImGui::PushStyleColor(ImGuiCol_Border, ui_.palette.border);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, kPad * ui_.scale});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin(("menu " + std::to_string(level)).c_str(), nullptr,
                 is_long ? kFlags & ~ImGuiWindowFlags_NoScrollbar : kFlags);
    ImGui::PopStyleColor(2);
    const Box box = {at, at + size};
    is_over_ = is_over_ || box.Contains(mouse_);
    ui_.items.Add("menu/window/" + std::to_string(level), box);
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (level >= state_.menu.open.size()) break;  // an entry was chosen
      DrawItem(level, items[i], static_cast<int>(i));
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
  }

  void DrawItem(std::size_t level, const MenuItem& item, int number) {
    if (item.is_line()) return DrawLine();
    OpenMenuState& menu = state_.menu.open[level];
    const Row row = NextRow(ui_, item.path, number == menu.choice, kEntry);
    if (row.hovered && mouse_moved_) Hover(level, item, number);
    if (state_.menu.open[level].choice == number) BringIntoView(state_.menu.open[level]);
    if (!row.visible) return;
    PaintItem(item, row.box);
    const bool is_chosen = state_.menu.open[level].choice == number;
    if (is_chosen && !item.why_not.empty()) {
      if (!row.hovered) {
        ImGui::SetNextWindowPos({row.box.max.x + 4 * ui_.scale, row.box.min.y});
      }
      Tooltip(ui_, item.why_not);
      ui_.items.Add("menu/why_not", row.box);
    }
    if (row.clicked) ChooseItem(state_, level, item);
  }

  // What keys have chosen. Once: then the mouse may scroll away from it.
  void BringIntoView(OpenMenuState& menu) const {
    if (std::exchange(menu.seen, menu.choice) == menu.choice || mouse_moved_) return;
    const float top = ImGui::GetWindowPos().y;
    const bool is_whole = ImGui::GetItemRectMin().y >= top &&
                          ImGui::GetItemRectMax().y <= top + ImGui::GetWindowHeight();
    if (!is_whole) ImGui::SetScrollHereY();
  }

  // The mouse chooses, and opens and closes submenus.
  void Hover(std::size_t level, const MenuItem& item, int number) {
    auto& open = state_.menu.open;
    if (open[level].choice == number && open.size() > level + 1) return;
    open[level].choice = number;
    open.resize(level + 1);
    if (!item.submenu.empty() && item.why_not.empty()) {
      open.push_back({item.submenu, {}, item.path, -1});
    }
  }

  void DrawLine() const {
    const Point at = FromIm(ImGui::GetCursorScreenPos());
    const float width = ImGui::GetContentRegionAvail().x;
    const float y = at.y + kLine / 2 * ui_.scale;
    ImGui::Dummy({width, kLine * ui_.scale});
    ui_.Fill(*ImGui::GetWindowDrawList(),
             {{at.x + kPad * ui_.scale, y}, {at.x + width - kPad * ui_.scale, y + 1}},
             ui_.palette.border);
  }

  void PaintItem(const MenuItem& item, const Box& box) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = kPad * ui_.scale;
    const bool can = item.why_not.empty();
    const Color ink = can ? ui_.palette.text : ui_.palette.text_dim;
    const Color dim = can ? ui_.palette.text_dim : ink;
    const float left = box.min.x + pad + kMark * ui_.scale;
    const std::string end = item.submenu.empty() ? item.keys : icon::kAngle;
    const float end_width = ui_.Width(end, Style(dim));
    if (item.is_on) {
      ui_.RowText(list, {box.min.x + 2 * pad, box.min.y}, box.height(), icon::kCheck,
                  Style(ui_.palette.accent));
    }
    const float room = box.max.x - 3 * pad - end_width - left;
    const bool is_path = item.title[0] == '/';
    ui_.RowText(list, {left, box.min.y}, box.height(),
                is_path ? ui_.CutStart(item.title, Style(ink), room) : item.title, Style(ink),
                room);
    ui_.RowText(list, {box.max.x - 2 * pad - end_width, box.min.y}, box.height(), end, Style(dim));
  }

  // The menu of the bar that the mouse is over opens in the place of another one.
  void FollowBar() {
    const std::string open = state_.menu.open.front().name;
    for (const BarMenu& menu : kBarMenus) {
      const std::string name(menu.name);
      const Box* const box = ui_.items.Find("menu/" + name);
      if (!box || !box->Contains(mouse_) || name == open || !IsOfBar(open)) continue;
      OpenMenuBelow(state_, name, "menu/" + name);
      state_.menu.open.front().choice = -1;
    }
  }

  bool IsOfBar(const std::string& menu) const {
    return state_.menu.open.front().below == "menu/" + menu;
  }

  const Ui& ui_;
  EditorState& state_;
  const Point mouse_;
  bool mouse_moved_ = false;
  bool is_over_ = false;  // the mouse, a menu
};

}  // namespace

void DrawMenus(const Ui& ui, EditorState& state) {
  if (!state.menu.open.empty()) Menus(ui, state).Draw();
}

}  // namespace coppice::editor
