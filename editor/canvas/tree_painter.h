// Paints a tree: the ground of its SubTrees, its lines, its nodes. For the canvas and for pictures.
#ifndef COPPICE_EDITOR_CANVAS_TREE_PAINTER_H_
#define COPPICE_EDITOR_CANVAS_TREE_PAINTER_H_

#include "editor/canvas/canvas.h"
#include "editor/canvas/paint/pen.h"
#include "editor/canvas/visible_nodes.h"

namespace coppice::editor {

/// Where a tree is painted: `camera` is that of the view with the area's corner added.
struct PaintArea {
  const TreeView& view;
  const CanvasOptions& options;
  Camera camera;
  Box box;
  const std::vector<VisibleNode>& visible;
  const VisibleNode* hovered = nullptr;  ///< one of `visible`, or null
};

void PaintTree(Pen& pen, const PaintArea& area);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_TREE_PAINTER_H_
