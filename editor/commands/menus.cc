#include "editor/commands/menus.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "editor/commands/menu_tables.h"

namespace coppice::editor {
namespace {

// Commands, and the menus that they open.
constexpr std::string_view kRecent = "file.recent";
constexpr std::string_view kRobots = "robot.known";
constexpr std::string_view kScale = "view.scale";

MenuItem ItemOf(const EditorCommand& command) {
  MenuItem item;
  item.path = "menu/" + command.id;
  item.title = command.title;
  item.keys = ToString(command.keys);
  item.why_not = command.WhyNot();
  item.is_on = command.is_on && command.is_on();
  item.run = command.run;
  for (const std::string_view menu : {kRecent, kRobots, kScale}) {
    if (command.id == menu) item.submenu = command.id;
  }
  return item;
}

// A file that is gone is grey.
std::vector<MenuItem> RecentItems(EditorState& state) {
  std::vector<MenuItem> items;
  for (const std::string& path : state.recent.files) {
    MenuItem item;
    item.path = "menu/recent/" + std::to_string(items.size());
    item.title = path;
    if (!state.paths.IsThere(path, state.now)) item.why_not = "this file no longer exists";
    item.run = [&state, path] { state.services.open_file(path); };
    items.push_back(std::move(item));
  }
  return items;
}

std::vector<MenuItem> RobotItems(EditorState& state) {
  std::vector<MenuItem> items;
  for (const OfferedRobot& robot : state.OfferedRobots()) {
    MenuItem item;
    item.path = "menu/robot/" + std::to_string(items.size());
    item.title = robot.endpoint;
    item.keys = robot.is_known ? robot.note : "found: " + robot.note;
    item.run = [&state, endpoint = robot.endpoint] { state.Connect(endpoint); };
    items.push_back(std::move(item));
  }
  return items;
}

// -1 if it has none.
int NextChoice(const std::vector<MenuItem>& items, int from, int by) {
  const int count = static_cast<int>(items.size());
  for (int i = 0, at = from; i < count; ++i) {
    at = from < 0 && i == 0 ? (by > 0 ? 0 : count - 1) : (at + by + count) % count;
    if (!items[static_cast<std::size_t>(at)].is_line()) return at;
  }
  return -1;
}

// The next entry behind the chosen one that begins with that letter.
int WithLetter(const std::vector<MenuItem>& items, int from, Key letter) {
  const int count = static_cast<int>(items.size());
  for (int i = 1; i <= count; ++i) {
    const int at = (std::max(from, -1) + i) % count;
    const std::string& title = items[static_cast<std::size_t>(at)].title;
    if (!title.empty() && std::toupper(static_cast<unsigned char>(title[0])) == letter) return at;
  }
  return from;
}

void OpenSubmenu(EditorState& state, std::size_t level, const MenuItem& item, bool by_key) {
  auto& open = state.menu.open;
  open.resize(level + 1);
  open.push_back({item.submenu, {}, item.path, by_key ? 0 : -1});
}

}  // namespace

std::vector<MenuItem> ItemsOf(EditorState& state, std::string_view menu) {
  if (menu == kRecent) return RecentItems(state);
  if (menu == kRobots) return RobotItems(state);
  std::vector<MenuItem> items;
  for (const std::string_view id : CommandsOf(menu, state.workspace.run() != nullptr)) {
    const EditorCommand* const command = state.commands.Find(id);
    if (id.empty()) items.emplace_back();
    if (command) items.push_back(ItemOf(*command));
  }
  return items;
}

void OpenMenu(EditorState& state, std::string menu, Point at) {
  state.menu.open = {{std::move(menu), at, {}, -1}};
}

void OpenMenuBelow(EditorState& state, std::string menu, std::string item) {
  state.menu.open = {{std::move(menu), {}, std::move(item), 0}};
}

void StepInBar(EditorState& state, int by) {
  const int count = static_cast<int>(std::size(kBarMenus));
  for (int i = 0; i < count; ++i) {
    if (kBarMenus[i].name != state.menu.open.front().name) continue;
    const std::string name(kBarMenus[(i + by + count) % count].name);
    return OpenMenuBelow(state, name, "menu/" + name);
  }
}

void ChooseItem(EditorState& state, std::size_t level, const MenuItem& item) {
  if (item.is_line() || !item.why_not.empty()) return;
  if (!item.submenu.empty()) return OpenSubmenu(state, level, item, true);
  state.menu.open.clear();  // before it runs: it may open another
  item.run();
}

void PressInMenu(EditorState& state, KeyEvent key) {
  const std::size_t level = state.menu.open.size() - 1;
  OpenMenuState& menu = state.menu.open.back();
  const std::vector<MenuItem> items = ItemsOf(state, menu.name);
  const MenuItem* const chosen = menu.choice >= 0 && menu.choice < static_cast<int>(items.size())
                                     ? &items[static_cast<std::size_t>(menu.choice)]
                                     : nullptr;
  switch (key.key) {
    case kKeyEscape:
      return state.menu.open.pop_back();
    case kKeyDown:
    case kKeyUp:
      menu.choice = NextChoice(items, menu.choice, key.key == kKeyDown ? 1 : -1);
      return;
    case kKeyRight:
      if (chosen && !chosen->submenu.empty()) return ChooseItem(state, level, *chosen);
      return StepInBar(state, 1);
    case kKeyLeft:
      if (level > 0) return state.menu.open.pop_back();
      return StepInBar(state, -1);
    case kKeyEnter:
    case kKeyKeypadEnter:
      if (chosen) ChooseItem(state, level, *chosen);
      return;
    default:
      menu.choice = WithLetter(items, menu.choice, key.key);
  }
}

}  // namespace coppice::editor
