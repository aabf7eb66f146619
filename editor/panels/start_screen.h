// What the canvas shows while there is no tree on it: how to get one, or why there is none.
//
// Registers "start/open", "start/new", "start/connect" and "start/recent/0".
#ifndef COPPICE_EDITOR_PANELS_START_SCREEN_H_
#define COPPICE_EDITOR_PANELS_START_SCREEN_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

void DrawStartScreen(const Ui& ui, EditorState& state, const Box& canvas);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_START_SCREEN_H_
