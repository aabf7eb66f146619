// The commands that change trees and files, with their keys.
#ifndef COPPICE_EDITOR_COMMANDS_EDIT_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_EDIT_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands; `state` must outlive them, here and in the other files.
void AddEditCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_EDIT_COMMANDS_H_
