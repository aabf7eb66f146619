// The rows of a node below its title: the type, and the ports with their values. A value that is a
// key is a chip in the colour of the key.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_NODE_LINES_H_
#define COPPICE_EDITOR_CANVAS_PAINT_NODE_LINES_H_

#include "editor/canvas/paint/node_look.h"
#include "editor/canvas/paint/pen.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

/// Paints them into the body of the node, which begins with the title row.
void PaintNodeLines(Pen& pen, const Scene& scene, const SceneNode& node, const NodeLook& look,
                    const Box& body);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_NODE_LINES_H_
