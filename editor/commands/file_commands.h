// Commands about files: open, save, what is not saved, quit.
#ifndef COPPICE_EDITOR_COMMANDS_FILE_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_FILE_COMMANDS_H_

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

void AddFileCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_FILE_COMMANDS_H_
