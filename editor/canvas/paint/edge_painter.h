// Paints the lines between parents and children. A line has the status of its child: the running
// path is thick, with dots that walk in the direction of the tick.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_EDGE_PAINTER_H_
#define COPPICE_EDITOR_CANVAS_PAINT_EDGE_PAINTER_H_

#include "editor/canvas/paint/edge_shape.h"
#include "editor/canvas/paint/node_look.h"
#include "editor/canvas/paint/pen.h"

namespace coppice::editor {

struct EdgeLook {
  EdgeEnds ends;    ///< on the screen
  NodeState state;  ///< of the child
  bool offline = false;
  std::uint32_t number = 1;  ///< of the child; painted beside its end unless 0
  Change change = Change::kNone;
  float strength = 1;
  bool stem = true;  ///< false: the stem is left out, because a sibling's line covers it
};

void PaintEdge(Pen& pen, const EdgeLook& look);

/// From afar, where nodes are blocks: a thin line without corners, numbers and motion.
void PaintFarEdge(Pen& pen, const EdgeLook& look);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_EDGE_PAINTER_H_
