// Commands that paint and compare trees: file.export, file.compare, file.stop_comparing.
#ifndef COPPICE_EDITOR_COMMANDS_PICTURE_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_PICTURE_COMMANDS_H_

#include <functional>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

void AddPictureCommands(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_PICTURE_COMMANDS_H_
