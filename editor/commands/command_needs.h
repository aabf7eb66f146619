// What commands need to be done, and how that is said of entries of menus that are grey.
#ifndef COPPICE_EDITOR_COMMANDS_COMMAND_NEEDS_H_
#define COPPICE_EDITOR_COMMANDS_COMMAND_NEEDS_H_

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Gives the commands of state.commands their EditorCommand::why_not. Once, when all are added.
void AddNeeds(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_COMMAND_NEEDS_H_
