// Paints the lines of a tree, in its order of importance: those at rest, then those with a result,
// then the running path. Siblings at rest share their stem, which is painted once.
#ifndef COPPICE_EDITOR_CANVAS_TREE_LINES_H_
#define COPPICE_EDITOR_CANVAS_TREE_LINES_H_

#include "editor/canvas/paint/pen.h"
#include "editor/canvas/tree_painter.h"

namespace coppice::editor {

void PaintLines(Pen& pen, const PaintArea& area);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_TREE_LINES_H_
