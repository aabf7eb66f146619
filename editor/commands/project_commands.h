// The commands about whole trees, files and names: extract, inline, rename everywhere, find and
// replace, go to.
#ifndef COPPICE_EDITOR_COMMANDS_PROJECT_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_PROJECT_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands; `state` must outlive them.
void AddProjectCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_PROJECT_COMMANDS_H_
