// Changes the keys of commands, and keeps the change in the user's file.
#ifndef COPPICE_EDITOR_WORKSPACE_KEY_SETTINGS_H_
#define COPPICE_EDITOR_WORKSPACE_KEY_SETTINGS_H_

#include <string>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// The other command whose keys these are at the same time; null if they are free.
const EditorCommand* OtherWithKeys(const EditorState& state, const EditorCommand& command,
                                   KeyChord keys);

/// Gives the command these keys, or none (key 0), and takes them away from the others that have
/// them at the same time.
void GiveKeys(EditorState& state, const std::string& id, KeyChord keys, double now);

/// The command has the keys again that it came with.
void GiveOwnKeys(EditorState& state, const std::string& id, double now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_KEY_SETTINGS_H_
