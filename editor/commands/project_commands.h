// The commands about whole trees, files and names: extract, inline, rename everywhere, find and
// replace, go to.
#ifndef COPPICE_EDITOR_COMMANDS_PROJECT_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_PROJECT_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds them to state.commands; `now` gives the seconds of the editor. `state` must outlive them.
void AddProjectCommands(EditorState& state, std::function<double()> now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_PROJECT_COMMANDS_H_
