// Which commands stand in which menu.
#ifndef COPPICE_EDITOR_COMMANDS_MENU_TABLES_H_
#define COPPICE_EDITOR_COMMANDS_MENU_TABLES_H_

#include <string_view>
#include <vector>

namespace coppice::editor {

/// IDs of the commands of the menu of that name, in order; an empty one is a line between groups.
/// Of a thing, only those for what is shown: a file, or a run.
/// A command with a menu of its own ("file.recent") stands for that menu.
std::vector<std::string_view> CommandsOf(std::string_view menu, bool in_run);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_MENU_TABLES_H_
