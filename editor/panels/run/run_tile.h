// The tile about the shown run, with a tab for each question.
#ifndef COPPICE_EDITOR_PANELS_RUN_RUN_TILE_H_
#define COPPICE_EDITOR_PANELS_RUN_RUN_TILE_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Why, what runs, breakpoints, statistics and comparison of the shown run. "run/why".
void DrawRunTile(const Ui& ui, EditorState& state, const Box& box);

/// Below that not all of its tabs are shown.
float RunTabsWidth(const Ui& ui, const EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_RUN_RUN_TILE_H_
