// The dialog for a file that somebody else has changed in the same places as the user.
#ifndef COPPICE_EDITOR_COMMANDS_MERGE_COMMANDS_H_
#define COPPICE_EDITOR_COMMANDS_MERGE_COMMANDS_H_

#include <functional>
#include <string>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// "file.resolve".
void AddMergeCommands(EditorState& state);

/// The file that waits for the user's word, or empty.
std::string DisputedFile(const EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_COMMANDS_MERGE_COMMANDS_H_
