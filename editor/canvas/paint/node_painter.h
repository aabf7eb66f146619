// Paints one node: shape first, colour second, so that it reads without colours too.
//
// Three levels of detail by zoom: everything; name, glyph and status; blocks in the status colour.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_NODE_PAINTER_H_
#define COPPICE_EDITOR_CANVAS_PAINT_NODE_PAINTER_H_

#include "editor/canvas/layout/node_metrics.h"
#include "editor/canvas/paint/node_look.h"
#include "editor/canvas/paint/pen.h"

namespace coppice::editor {

enum class Detail : std::uint8_t { kFull, kName, kBlock };

/// Above 60 % everything, below 30 % blocks.
Detail DetailFor(float zoom, float screen_scale = 1);

void PaintNode(Pen& pen, const Scene& scene, const SceneNode& node, const NodeLook& look);

/// The node itself on the screen, without the note above it and the chip below it.
Box BodyBox(const SceneNode& node, const NodeLook& look);

/// The place of the [+] or [-] that opens and closes a SubTree, on the screen.
Box ToggleBox(const SceneNode& node, const NodeLook& look);

/// The row that stands for collapsed children, on the screen.
Box ChipBox(const NodeLook& look);

/// Where port number `port` of the node (from 0) is painted at full detail: its whole row.
Box PortBox(const Scene& scene, const SceneNode& node, const NodeLook& look, std::uint32_t port);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_NODE_PAINTER_H_
