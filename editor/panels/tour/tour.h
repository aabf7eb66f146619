// The shown step of the tour: a frame around what it is about, and a bubble beside it.
#ifndef COPPICE_EDITOR_PANELS_TOUR_TOUR_H_
#define COPPICE_EDITOR_PANELS_TOUR_TOUR_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Behind the tiles, which must have been drawn. "tour", "tour/next", "tour/back", "tour/end",
/// "tour/item".
void DrawTour(const Ui& ui, EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_TOUR_TOUR_H_
