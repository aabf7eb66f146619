// What lies over everything else until it is answered.
#ifndef COPPICE_EDITOR_PANELS_POPUP_POPUP_H_
#define COPPICE_EDITOR_PANELS_POPUP_POPUP_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// The open popup, if any: prompts, the command palette, the list of keys. "popup/input",
/// "popup/0".
void DrawPopup(const Ui& ui, EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_POPUP_POPUP_H_
