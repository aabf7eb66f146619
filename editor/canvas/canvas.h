// The canvas: paints a TreeView with the statuses of a robot, and lets the user walk in it with the
// mouse. Registers "canvas/TREE/PATH" for nodes, "canvas/TREE/PATH/toggle" for what opens and
// closes them, and "canvas/minimap".
#ifndef COPPICE_EDITOR_CANVAS_CANVAS_H_
#define COPPICE_EDITOR_CANVAS_CANVAS_H_

#include "editor/canvas/tree_view.h"
#include "editor/live/live_snapshot.h"
#include "editor/look/ui.h"

namespace coppice::editor {

struct CanvasOptions {
  bool minimap = true;
  const LiveSnapshot* live = nullptr;  ///< null: no statuses
};

/// State of a node on the robot; idle if there is none.
NodeState StateOf(const LiveSnapshot* live, const SceneNode& node);

/// Draws into `box` of the current ImGui window and handles the mouse there.
void DrawCanvas(const Ui& ui, TreeView& view, const Box& box, const CanvasOptions& options);

/// The small picture of the whole tree in the upper right corner of `box`; a click moves the
/// camera.
void DrawMinimap(const Ui& ui, TreeView& view, const Box& box, const LiveSnapshot* live);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_CANVAS_H_
