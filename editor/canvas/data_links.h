// The key that a user has asked about: its lines from those who write to those who read.
#ifndef COPPICE_EDITOR_CANVAS_DATA_LINKS_H_
#define COPPICE_EDITOR_CANVAS_DATA_LINKS_H_

#include "editor/canvas/paint/pen.h"
#include "editor/canvas/tree_view.h"

namespace coppice::editor {

/// Paints them above the nodes. `camera` is that of the view with the canvas' corner added.
void PaintDataLinks(Pen& pen, const TreeView& view, const Camera& camera);

/// True if the node uses the lit key, or if none is lit.
bool IsLit(const TreeView& view, std::uint32_t node);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_DATA_LINKS_H_
