// Where the nodes of a tree go: all of it is either the tidy tree of tidy_tree.h or in the rows of
// wrapped_tree.h. Some nodes share a block.
//
//   compact   a decorator lies directly on its child, as a strip of the same width
//   stacked   more than eight leaves in a row of a tidy tree become a column below their parent
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

/// Which way a tree grows. By itself: down, but across where only so its names can be read.
enum class Growth : std::uint8_t { kByItself, kDown, kAcross };

/// What the user wants of all trees.
struct LayoutStyle {
  Growth growth = Growth::kByItself;
  bool layered = false;
  bool compact = false;
  bool stacked = false;  ///< top to bottom only: sideways, leaves stand in a column anyway
  bool wrapped = true;   ///< in rows where it does not fit; not if layered
  ShownPorts ports = ShownPorts::kByItself;
  bool whole_values = false;  ///< nothing is cut, for there is no mouse to ask
};
inline bool operator==(const LayoutStyle& a, const LayoutStyle& b) {
  return a.growth == b.growth && a.layered == b.layered && a.compact == b.compact &&
         a.stacked == b.stacked && a.wrapped == b.wrapped && a.ports == b.ports &&
         a.whole_values == b.whole_values;
}

/// What is chosen for one tree on one canvas (layout_choice.h).
struct LayoutChoice {
  Orientation orientation = Orientation::kTopToBottom;
  bool names_only = false;
  bool compact = false;  ///< although the style does not ask for it
  float rows = 0;        ///< in rows, broken where they would be longer than that; 0: the tidy tree
  float limit = 1e9F;    ///< of how long rows are together with what is left of them
  bool packed = false;   ///< rows are broken where they take the least room within that limit
};
inline bool operator==(const LayoutChoice& a, const LayoutChoice& b) {
  return a.orientation == b.orientation && a.names_only == b.names_only && a.compact == b.compact &&
         a.rows == b.rows && a.limit == b.limit && a.packed == b.packed;
}

/// So many leaves in a row stay side by side.
inline constexpr std::uint32_t kMostLeavesInARow = 8;

/// How a node hangs on its parent.
enum class Link : std::uint8_t {
  kNone,   ///< the root, or the child that a decorator lies on
  kCurve,  ///< a line of its own
  kTrunk,  ///< in a column of leaves: a branch of the line along their left side
  kRow     ///< in a row: a branch of the line along all rows of its parent
};

struct TreeLayout {
  std::vector<Box> boxes;  ///< in the order of the nodes; the smallest x and y are 0
  std::vector<Link> links;
  Box bounds;  ///< around all of them
};

/// A tree in preorder: the descendants of node i are i + 1 .. ends[i] - 1.
struct MeasuredTree {
  std::vector<std::uint32_t> ends;
  std::vector<NodeSizes> sizes;
  std::vector<bool> is_decorator;
};

/// Linear in the number of nodes.
TreeLayout Arrange(const MeasuredTree& tree, const LayoutStyle& style, const LayoutChoice& choice);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_TREE_LAYOUT_H_
