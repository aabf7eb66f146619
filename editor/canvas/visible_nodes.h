// What of a tree is on the canvas. Takes time for what is seen, not for the tree: a branch that is
// out of sight is skipped as a whole, one of a few pixels is a single block.
#ifndef COPPICE_EDITOR_CANVAS_VISIBLE_NODES_H_
#define COPPICE_EDITOR_CANVAS_VISIBLE_NODES_H_

#include <vector>

#include "editor/canvas/tree_view.h"

namespace coppice::editor {

struct VisibleNode {
  std::uint32_t k = 0;  ///< of TreeView::shown()
  Box box;              ///< on the screen
  bool whole_branch = false;
};

/// `camera` is that of the view with the canvas' corner added. Nodes come in preorder; one that is
/// out of sight itself may be among them for its line.
std::vector<VisibleNode> FindVisible(const TreeView& view, const Camera& camera, const Box& canvas,
                                     double now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_VISIBLE_NODES_H_
