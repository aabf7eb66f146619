// The tile of time: what ran when.
#ifndef COPPICE_EDITOR_PANELS_TIMELINE_TIMELINE_H_
#define COPPICE_EDITOR_PANELS_TIMELINE_TIMELINE_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Time: lanes of nodes, ticks and a key. "timeline/PATH", "timeline/overview", "timeline/now".
void DrawTimeline(const Ui& ui, EditorState& state, const Box& box);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_TIMELINE_TIMELINE_H_
