// Paints what is marked at a node: breakpoints, where the tree stands, faults. Shape first: a disc
// is a breakpoint, hollow if it is switched off, a second ring where the tree stands; a flag with
// an exclamation mark is a fault.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_MARK_PAINTER_H_
#define COPPICE_EDITOR_CANVAS_PAINT_MARK_PAINTER_H_

#include "editor/canvas/paint/node_look.h"
#include "editor/canvas/paint/pen.h"

namespace coppice::editor {

void PaintMarks(Pen& pen, const NodeLook& look);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_MARK_PAINTER_H_
