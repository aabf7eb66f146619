// Where the nodes of a tree go: the tidy tree of tidy_tree.h, in which some nodes share a block.
//
//   compact   a decorator lies directly on its child, as a strip of the same width
//   stacked   more than eight leaves in a row become a column below their parent
//   wrapped   what would be far wider than high stands in rows (wrapped_tree.h), and very many
//             leaves in several columns
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_TREE_LAYOUT_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_TREE_LAYOUT_H_

#include <cstdint>
#include <vector>

#include "editor/canvas/layout/tidy_tree.h"

namespace coppice::editor {

/// Of a node at zoom 1, without the row for collapsed children.
struct NodeSizes {
  NodeSizes(Point both = {}) : NodeSizes(both, both) {}  // NOLINT: a size is its sizes
  NodeSizes(Point with_ports, Point with_name_alone) : full(with_ports), name(with_name_alone) {}
  Point full;
  Point name;
};

/// What a node shows below its name. By itself: nothing where a whole tree would be fitted so small
/// that ports could not be read.
enum class ShownPorts : std::uint8_t { kByItself, kAll, kNone };

struct LayoutStyle {
  Orientation orientation = Orientation::kTopToBottom;
  bool layered = false;
  bool compact = false;
  bool stacked = true;  ///< top to bottom only: sideways, leaves stand in a column anyway
  bool wrapped = true;  ///< not if layered
  ShownPorts ports = ShownPorts::kByItself;
};
inline bool operator==(const LayoutStyle& a, const LayoutStyle& b) {
  return a.orientation == b.orientation && a.layered == b.layered && a.compact == b.compact &&
         a.stacked == b.stacked && a.wrapped == b.wrapped && a.ports == b.ports;
}

/// So many leaves in a row stay side by side.
inline constexpr std::uint32_t kMostLeavesInARow = 8;

/// How a node hangs on its parent.
enum class Link : std::uint8_t {
  kNone,      ///< the root, or the child that a decorator lies on
  kCurve,     ///< a line of its own
  kTrunk,     ///< in a column of leaves: a branch of the line along their left side
  kRow,       ///< in a row: a branch of the line along all rows of its parent
  kRowColumn  ///< in a column of leaves that stands in such a row
};

struct TreeLayout {
  std::vector<Box> boxes;  ///< in the order of the nodes; the smallest x and y are 0
  std::vector<Link> links;
  std::vector<float> below_row;  ///< of kRowColumn: how far it begins below the row; else 0
  Box bounds;                    ///< around all of them
};

/// Lays out a tree given in preorder: the descendants of node i are i + 1 .. ends[i] - 1. Sizes are
/// width (x) and height (y). `breadth`: as LayoutOptions. Linear in the number of nodes.
TreeLayout Arrange(const std::vector<std::uint32_t>& ends, const std::vector<Point>& sizes,
                   const std::vector<bool>& is_decorator, const LayoutStyle& style,
                   float breadth = 0);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_TREE_LAYOUT_H_
