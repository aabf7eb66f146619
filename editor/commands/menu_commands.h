// The commands that open menus, and those that exist for them.
#ifndef COPPICE_EDITOR_COMMANDS_MENU_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_MENU_COMMANDS_H_

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands.
void AddMenuCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_MENU_COMMANDS_H_
