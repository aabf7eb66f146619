// The screen: bars above, a column of tiles left and right, the canvas between them over a row of
// tiles. Tiles that are hidden leave their room to their neighbours; the gaps can be dragged.
#ifndef COPPICE_EDITOR_PANELS_TILES_H_
#define COPPICE_EDITOR_PANELS_TILES_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Draws everything but the popup into `box` of the current ImGui window.
void DrawTiles(const Ui& ui, EditorState& state, const Box& box);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_TILES_H_
