// Rows of children (wrapped_tree.h) that take the least room: every branch is measured in several
// shapes, from narrow and deep to broad and shallow, and those are taken that fit together best.
// More work than breaking rows where they are too long, so for trees that must be read as a whole.
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_PACKED_ROWS_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_PACKED_ROWS_H_

#include <cstdint>
#include <vector>

#include "editor/theme/geometry.h"

namespace coppice::editor {

/// Distances, as in RowOptions.
struct RowGaps {
  float sibling = 18;
  float level = 38;
  float indent = 34;
};

/// Where each node of a tree in preorder is below its parent, top to bottom: the least depth within
/// the breadth `limit`, as far as the nodes allow it.
std::vector<Point> PackRows(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                            const RowGaps& gaps, float limit);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_PACKED_ROWS_H_
