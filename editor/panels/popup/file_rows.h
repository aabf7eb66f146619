// The rows and keys of the file dialog, below the field of the popup.
#ifndef COPPICE_EDITOR_PANELS_POPUP_FILE_ROWS_H_
#define COPPICE_EDITOR_PANELS_POPUP_FILE_ROWS_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// What is asked, and which folder is listed.
std::string FileHint(const EditorState& state);

/// "popup/0" and so on; does what the keys of this frame say.
void DrawFileRows(const Ui& ui, EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_POPUP_FILE_ROWS_H_
