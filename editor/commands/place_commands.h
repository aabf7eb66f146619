// The commands about places in runs: bookmarks, and "run to here".
#ifndef COPPICE_EDITOR_COMMANDS_PLACE_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_PLACE_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

void AddPlaceCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_PLACE_COMMANDS_H_
