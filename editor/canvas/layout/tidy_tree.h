// Where the boxes of a tree go: a tidy drawing for boxes of different sizes, in linear time.
//
// A. van der Ploeg, "Drawing non-layered tidy trees in linear time", Software: Practice and
// Experience 44(12), 2014, doi 10.1002/spe.2213. Siblings keep their order, a parent stands over
// the middle between the centers of its first and last child, no boxes overlap, and each box hangs
// directly below its parent, however high its neighbours are.
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_TIDY_TREE_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_TIDY_TREE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "editor/theme/geometry.h"

namespace coppice::editor {

enum class Orientation : std::uint8_t { kTopToBottom, kLeftToRight };

struct LayoutOptions {
  Orientation orientation = Orientation::kTopToBottom;
  float sibling_gap = 18;  ///< least distance of boxes side by side
  float level_gap = 38;    ///< distance of parent and child
  bool layered = false;    ///< all boxes of a depth begin at the same line
};

struct TidyTree {
  std::vector<Box> boxes;  ///< in the order of the nodes; the smallest x and y are 0
  Box bounds;              ///< around all of them
  std::size_t steps = 0;   ///< work done: rounds of all loops together
};

/// Lays out a tree given in preorder: the descendants of node i are i + 1 .. ends[i] - 1. Sizes are
/// width (x) and height (y) as on the screen, whatever the orientation.
TidyTree LayOut(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                const LayoutOptions& options);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_TIDY_TREE_H_
