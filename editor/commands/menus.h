// What the menus hold: those of the bar, and those of a right click on a thing. Tables of commands
// decide; no menu is written by hand. Without ImGui: panels/menu draws what is here.
//
//   OpenMenu(state, menu::kNode, {120, 80});          // a right click on a node
//   for (const MenuItem& item : ItemsOf(state, menu::kNode)) ...
//   PressInMenu(state, {kKeyDown});                   // walks in it
//
// All on the thread of the editor.
#ifndef COPPICE_EDITOR_COMMANDS_MENUS_H_
#define COPPICE_EDITOR_COMMANDS_MENUS_H_

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Names of the menus of a right click.
namespace menu {
inline constexpr char kNode[] = "node";
inline constexpr char kLine[] = "line";      ///< from the selected node to its parent
inline constexpr char kCanvas[] = "canvas";  ///< where nothing is
inline constexpr char kRow[] = "row";        ///< of the outline
inline constexpr char kKey[] = "key";        ///< of the blackboard
inline constexpr char kLane[] = "lane";      ///< of the timeline
inline constexpr char kTree[] = "tree of a file";
inline constexpr char kTab[] = "tab";
}  // namespace menu

/// A menu of the bar; its item is "menu/NAME".
struct BarMenu {
  std::string_view title;
  std::string_view name;
};
/// From the left.
inline constexpr BarMenu kBarMenus[] = {
    {"File", "file"}, {"Edit", "edit"},         {"Tree", "tree"},
    {"View", "view"}, {"Tiles", "tiles"},       {"Robot", "robot"},
    {"Run", "run"},   {"Simulate", "simulate"}, {"Help", "help"}};

/// An entry of a menu, as it is now.
struct MenuItem {
  std::string path;  ///< in the registry of items: "menu/edit.copy"; empty: a line between groups
  std::string title;
  std::string keys;
  std::string why_not;  ///< why it cannot be done now; empty: it can
  bool is_on = false;   ///< of a switch
  std::string submenu;  ///< the menu that it opens; empty: none
  std::function<void()> run;

  bool is_line() const { return path.empty(); }
};

/// Of the menu of that name; none if there is no such menu.
std::vector<MenuItem> ItemsOf(EditorState& state, std::string_view menu);

/// Opens a menu with its corner at `at`. What it is about must be selected.
void OpenMenu(EditorState& state, std::string menu, Point at);

/// Opens a menu below the item of that path, with its first entry chosen: for keys.
void OpenMenuBelow(EditorState& state, std::string menu, std::string item);

/// Opens another one in its place, in the bar: by 1 or -1, round the end.
void StepInBar(EditorState& state, int by);

/// Closes all menus and does what the entry says, or opens its submenu. Grey ones do nothing.
void ChooseItem(EditorState& state, std::size_t level, const MenuItem& item);

/// Arrows, Enter, first letters, Esc. There must be an open menu.
void PressInMenu(EditorState& state, KeyEvent key);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_MENUS_H_
