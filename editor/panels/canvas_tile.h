// The canvas with all that belongs to it in the editor: problems as badges, drag and drop, the
// comparison with another version.
#ifndef COPPICE_EDITOR_PANELS_CANVAS_TILE_H_
#define COPPICE_EDITOR_PANELS_CANVAS_TILE_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Draws the shown tree; there must be one. "canvas/TREE/PATH", "comparison/close".
void DrawCanvasTile(const Ui& ui, EditorState& state, const Box& box);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_CANVAS_TILE_H_
