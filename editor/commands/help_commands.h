// The examples and the tour.
#ifndef COPPICE_EDITOR_COMMANDS_HELP_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_HELP_COMMANDS_H_

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands.
void AddHelpCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_HELP_COMMANDS_H_
