// The tidy tree of tidy_tree.h, but for branches that would be far wider than high: their nodes
// have their children in rows, one below the other and each read from left to right, as words in a
// text.
//
//   node            The children of such a node are indented below it, so that a line along their
//   |- a  b  c      left side can lead to every row. From left to right, rows are columns.
//   |- d  e
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_WRAPPED_TREE_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_WRAPPED_TREE_H_

#include <vector>

#include "editor/canvas/layout/tidy_tree.h"

namespace coppice::editor {

struct WrappedTree {
  std::vector<Box> boxes;      ///< in the order of the nodes; the smallest x and y are 0
  std::vector<bool> has_rows;  ///< its children stand in rows
  Box bounds;                  ///< around all of them
};

/// As LayOut. Linear in the number of nodes; a branch that is narrow enough is laid out as there.
WrappedTree LayOutWrapped(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                          const LayoutOptions& options);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_WRAPPED_TREE_H_
