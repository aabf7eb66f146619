// The commands of the editor and their keys.
#ifndef COPPICE_EDITOR_COMMANDS_STANDARD_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_STANDARD_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands; `state` must outlive them.
void AddStandardCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_STANDARD_COMMANDS_H_
