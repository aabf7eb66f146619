// The commands that change trees and files, with their keys.
#ifndef COPPICE_EDITOR_COMMANDS_EDIT_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_EDIT_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands. `now` gives the editor's time in seconds; both must outlive the
/// commands.
void AddEditCommands(EditorState& state, std::function<double()> now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_EDIT_COMMANDS_H_
