// What the canvas shows while there is no tree on it: how to get one, or why there is none.
//
// Registers "start/open", "start/new", "start/connect", "start/tour", "start/example_tree",
// "start/example_record", "start/example_robot", "start/recent/0", "start/robot/0",
// "start/robot/0/forget", and for unsaved work of editors that have ended "start/unsaved/0" and
// "start/unsaved/0/forget".
#ifndef COPPICE_EDITOR_PANELS_START_SCREEN_H_
#define COPPICE_EDITOR_PANELS_START_SCREEN_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

void DrawStartScreen(const Ui& ui, EditorState& state, const Box& canvas);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_START_SCREEN_H_
