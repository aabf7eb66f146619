// What a run adds to its nodes on the canvas besides their statuses.
#ifndef COPPICE_EDITOR_PANELS_RUN_RUN_MARKS_H_
#define COPPICE_EDITOR_PANELS_RUN_RUN_MARKS_H_

#include <vector>

#include "editor/canvas/paint/node_look.h"
#include "editor/live/heat_map.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Of the statistics, or of the coverage while that is shown, if a heat map is wanted; else without
/// values.
HeatMap RunHeat(EditorState& state, const TreeView& view);

/// The nodes that did something else in the run that the shown one was compared with; empty if it
/// was compared with none.
std::vector<Change> RunDifferences(const EditorState& state, const TreeView& view);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_RUN_RUN_MARKS_H_
