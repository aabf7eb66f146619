// Paints one node: shape first, colour second, so that it reads without colours too.
//
// Three levels of detail by zoom: everything; name, glyph and status; blocks in the status colour.
#ifndef COPPICE_EDITOR_CANVAS_NODE_PAINTER_H_
#define COPPICE_EDITOR_CANVAS_NODE_PAINTER_H_

#include "editor/canvas/node_metrics.h"
#include "editor/live/live_snapshot.h"

namespace coppice::editor {

enum class Detail : std::uint8_t { kFull, kName, kBlock };

/// Above 60 % everything, below 30 % blocks.
Detail DetailFor(float zoom);

/// How a node is to be painted now.
struct NodeLook {
  Box box;  ///< on the screen
  float zoom = 1;
  NodeState state;
  bool selected = false;
  bool hovered = false;
  bool collapsed = false;
  bool offline = false;                  ///< the robot does not answer: statuses are the last known
  std::uint32_t hidden = 0;              ///< descendants of a collapsed node
  Status hidden_status = Status::kIdle;  ///< kRunning if one of them runs
};

/// Colour of the status, of the idle trail if the node is idle, else of nodes at rest.
Color StatusColor(const Palette& palette, const NodeState& state, Color at_rest);

void PaintNode(const Ui& ui, ImDrawList& list, const Scene& scene, const SceneNode& node,
               const NodeLook& look);

/// The place of the [+] or [-] that opens and closes a SubTree, on the screen.
Box ToggleBox(const NodeLook& look);

/// The row that stands for collapsed children, on the screen.
Box ChipBox(const NodeLook& look);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_NODE_PAINTER_H_
