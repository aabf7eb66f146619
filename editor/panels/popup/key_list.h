// All commands with their keys, in a popup, and the popup in which a command gets other keys.
// Registers "popup/keys/ID".
#ifndef COPPICE_EDITOR_PANELS_POPUP_KEY_LIST_H_
#define COPPICE_EDITOR_PANELS_POPUP_KEY_LIST_H_

#include <string>
#include <vector>

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Those whose title, ID or keys fit what was typed, the best first; without a text all.
std::vector<const EditorCommand*> FindCommands(const CommandTable& commands,
                                               const std::string& typed);

/// Below the field in which one types. Enter or a click asks for other keys.
void DrawKeyList(const Ui& ui, EditorState& state);

/// Takes the keys that are pressed for the command that was chosen.
void DrawNewKeys(const Ui& ui, EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_POPUP_KEY_LIST_H_
