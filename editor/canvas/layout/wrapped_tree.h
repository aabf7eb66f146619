// A tree in rows, as words in a text: below each node, indented, stand its children from left to
// right, in several rows where one would be too long.
//
//   node            A line along the left side of the rows leads to every child.
//   |- a  b  c      From left to right, rows are columns.
//   |- d  e
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_WRAPPED_TREE_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_WRAPPED_TREE_H_

#include <vector>

#include "editor/canvas/layout/tidy_tree.h"

namespace coppice::editor {

struct RowOptions {
  Orientation orientation = Orientation::kTopToBottom;
  float sibling_gap = 18;  ///< least distance of boxes side by side
  float level_gap = 38;    ///< distance of a node and its first row, and of rows
  float indent = 34;       ///< of rows: room for the line to them
  float breadth = 2400;    ///< rows that are not longer are not broken
  float limit = 1e9F;      ///< of the whole tree, where its nodes allow it
  bool packed = false;     ///< broken where the whole is the least deep (packed_rows.h)
};

struct WrappedTree {
  std::vector<Box> boxes;  ///< in the order of the nodes; the smallest x and y are 0
  Box bounds;              ///< around all of them
};

/// Lays out a tree given in preorder, as LayOut does. Linear in the number of nodes, but if packed.
WrappedTree LayOutWrapped(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                          const RowOptions& options);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_WRAPPED_TREE_H_
