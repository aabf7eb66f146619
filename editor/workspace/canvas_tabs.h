// The tabs above the canvas: the trees of files that were shown, in the order of opening.
#ifndef COPPICE_EDITOR_WORKSPACE_CANVAS_TABS_H_
#define COPPICE_EDITOR_WORKSPACE_CANVAS_TABS_H_

#include <cstddef>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Adds the shown tree if it is new, and forgets trees that are gone. Once per frame.
void UpdateTabs(EditorState& state);

/// The number of the shown tree among the tabs; their count if it has none (a run).
std::size_t ShownTab(const EditorState& state);

void ShowTab(EditorState& state, std::size_t tab, double now);

/// Shows its neighbour if it was shown. The last tab stays.
void CloseTab(EditorState& state, std::size_t tab, double now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_CANVAS_TABS_H_
