// The canvas: paints a TreeView with the statuses of a robot, and lets the user walk in it with the
// mouse. Registers "canvas/TREE/PATH" for nodes, "canvas/TREE/PATH/toggle" for what opens and
// closes them, "canvas/TREE/PATH/port/NAME" for the rows of ports, and "canvas/minimap"
// or "canvas/minimap/folded".
//
// The wheel pans and zooms (wheel.h). The left button drags the canvas, or a node if there is a
// DropHandler; with Shift or Ctrl it draws a rectangle that selects. The other buttons always drag
// the canvas; a click of the right one opens a menu.
#ifndef COPPICE_EDITOR_CANVAS_CANVAS_H_
#define COPPICE_EDITOR_CANVAS_CANVAS_H_

#include <functional>
#include <vector>

#include "editor/canvas/drop_target.h"
#include "editor/canvas/paint/node_look.h"
#include "editor/canvas/tree_view.h"
#include "editor/canvas/visible_nodes.h"
#include "editor/live/heat_map.h"
#include "editor/live/values/port_values.h"
#include "editor/theme/ui.h"

namespace coppice::editor {

struct CanvasOptions {
  bool minimap = true;
  bool wheel_zooms = false;
  bool tooltips = true;                      ///< what the mouse rests on is explained beside it
  std::uint32_t unexplained = kNoSceneNode;  ///< but for this node: there is something beside it
  Box occupied;  ///< by what lies over the canvas, on the screen; the minimap keeps clear of it
  const TreeSnapshot* live = nullptr;            ///< null: no statuses
  const PortValues* port_values = nullptr;       ///< null: ports show their keys
  const std::vector<Badge>* badges = nullptr;    ///< by node of the scene; null or empty: none
  const HeatMap* heat = nullptr;                 ///< null: headers in the colours of the shapes
  const std::vector<Change>* changes = nullptr;  ///< by node of the scene; null: none
  std::function<void(std::uint32_t)> open;       ///< a SubTree was clicked twice; empty: collapse
  const DropHandler* drop = nullptr;             ///< null: nodes cannot be dragged
  /// The row of a port (of Scene::ports) was clicked twice; empty: as elsewhere on the node.
  std::function<void(std::uint32_t node, std::uint32_t port)> edit_port;
  /// A right click on a node, or on the line to it from its parent; kNoSceneNode: on neither.
  std::function<void(std::uint32_t node, bool is_line)> menu;
};

/// State of a node on the robot; idle if there is none.
NodeState StateOf(const TreeSnapshot* live, const SceneNode& node);

/// Draws into `box` of the current ImGui window and handles the mouse there.
void DrawCanvas(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options);

/// The small picture of the whole tree, in a corner of `box` where it hides none of the nodes; a
/// click moves the camera. Without such a corner it is folded till the mouse is on it, or gone.
void DrawMinimap(const Ui& ui, TreeView& view, const Box& box,
                 const std::vector<VisibleNode>& nodes, const CanvasOptions& options);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_CANVAS_H_
