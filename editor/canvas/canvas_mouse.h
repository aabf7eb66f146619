// The mouse on the canvas: clicks, the selecting rectangle, and what is dragged.
#ifndef COPPICE_EDITOR_CANVAS_CANVAS_MOUSE_H_
#define COPPICE_EDITOR_CANVAS_CANVAS_MOUSE_H_

#include "editor/canvas/canvas.h"
#include "editor/canvas/paint/pen.h"
#include "editor/canvas/visible_nodes.h"

namespace coppice::editor {

/// Handles the mouse in `box`. `hovered` is what lies below it, or null.
void HandleCanvasMouse(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options,
                       const VisibleNode* hovered);

/// Paints the selecting rectangle, or what is dragged, the place where it would go, and why it may
/// not. Calls the DropHandler when the button is let go.
void DrawGesture(Pen& pen, TreeView& view, const Box& box, const CanvasOptions& options);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_CANVAS_MOUSE_H_
