// The canvas with all that belongs to it in the editor: problems as badges, drag and drop, the
// comparison with another version.
#ifndef COPPICE_EDITOR_PANELS_CANVAS_TILE_H_
#define COPPICE_EDITOR_PANELS_CANVAS_TILE_H_

#include <vector>

#include "editor/canvas/paint/node_look.h"
#include "editor/live/heat_map.h"
#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Draws the shown tree; there must be one. "canvas/TREE/PATH", "comparison/close".
void DrawCanvasTile(const Ui& ui, EditorState& state, const Box& box);

/// What a run adds to its nodes: of the statistics, or of the coverage while that is shown, if a
/// heat map is wanted; else without values.
HeatMap RunHeat(EditorState& state, const TreeView& view);

/// The nodes that did something else in the run that the shown one was compared with; empty if it
/// was compared with none.
std::vector<Change> RunDifferences(const EditorState& state, const TreeView& view);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_CANVAS_TILE_H_
