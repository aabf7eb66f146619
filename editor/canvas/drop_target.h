// Where something that is dragged over a tree would go. The canvas says where; what that means, and
// whether it is allowed, is the business of who edits.
//
//   const DropTarget target = FindDropTarget(view, view.camera.ToWorld(mouse), now);
//   if (target.place == DropPlace::kGap) { /* before child number target.index of target.node */ }
#ifndef COPPICE_EDITOR_CANVAS_DROP_TARGET_H_
#define COPPICE_EDITOR_CANVAS_DROP_TARGET_H_

#include <cstdint>
#include <functional>
#include <string>

#include "editor/canvas/tree_view.h"

namespace coppice::editor {

enum class DropPlace : std::uint8_t {
  kNowhere,
  kGap,   ///< among the children of `node`, before number `index` (their count: behind the last)
  kNode,  ///< onto `node`: as its last child, or in its place
  kEdge,  ///< between `node` and its parent; for the root: above it
};

struct DropTarget {
  DropPlace place = DropPlace::kNowhere;
  std::uint32_t node = kNoSceneNode;  ///< of the scene
  std::uint32_t index = 0;            ///< of kGap
  Box mark;                           ///< in the world: the insertion bar, or the node
};

/// The same place; the marks are not looked at.
inline bool operator==(const DropTarget& a, const DropTarget& b) {
  return a.place == b.place && a.node == b.node && a.index == b.index;
}

/// What is below that point of the world. Takes time for what is near the point, not for the tree.
DropTarget FindDropTarget(const TreeView& view, Point world, double now);

/// Where, and which keys are held.
struct DropRequest {
  DropTarget target;
  bool copy = false;     ///< Shift
  bool replace = false;  ///< Alt: onto a node means in its place
};

/// The side that edits. Without `why_not` nothing can be dragged.
struct DropHandler {
  /// Why that cannot be dropped there, shown beside the mouse; empty if it can.
  std::function<std::string(const Drag&, const DropRequest&)> why_not;
  /// The button was let go over a target that `why_not` allows. Called during the frame: remember
  /// it and change the tree after the frame.
  std::function<void(const Drag&, const DropRequest&)> drop;
  /// Dragged from another tile over the canvas, or null. The canvas calls `drop` for it too.
  const Drag* incoming = nullptr;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_DROP_TARGET_H_
