// The way of a line from a parent to its child: a cubic Bezier curve, and for some a bent line
// behind it. A leaf in a column hangs on the trunk left of the column; what stands in a row, on the
// line along the left side of all rows.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_EDGE_SHAPE_H_
#define COPPICE_EDITOR_CANVAS_PAINT_EDGE_SHAPE_H_

#include <vector>

#include "editor/canvas/layout/tree_layout.h"

namespace coppice::editor {

struct EdgeEnds {
  Box parent;  ///< with its note
  Box child;
  Link link = Link::kCurve;
  Orientation orientation = Orientation::kTopToBottom;
  float zoom = 1;         ///< scales the distances of trunks; 1 in the world
  float parent_note = 0;  ///< height of the note on the parent
  float child_note = 0;
};

struct EdgeShape {
  Point a, b, c, d;           ///< the Bezier curve
  std::vector<Point> branch;  ///< from d on; may be empty
  Point arrival;              ///< where it meets the box of the child
};

EdgeShape ShapeOfEdge(const EdgeEnds& ends);

/// The stem is the beginning of a line that siblings in the same rows or the same column share:
/// that of a sibling covers those of all before it. Curves have none.
bool HasStem(const EdgeEnds& ends);

/// What comes behind the stem; the whole branch if there is none.
std::vector<Point> PartBehindStem(const EdgeShape& edge, const EdgeEnds& ends);

/// Around the stem and around what comes behind it, with the thickness of a line. Without a stem
/// both are around all.
struct EdgeBounds {
  Box stem;
  Box rest;
  float lane = 0;  ///< where the stem runs; siblings of the same lane share it
};
EdgeBounds BoundsOf(const EdgeEnds& ends);

/// Points along the whole edge, close enough to walk on.
std::vector<Point> PointsAlong(const EdgeShape& edge);

/// Distance of a point from the nearest place of the edge.
float DistanceTo(const EdgeShape& edge, Point point);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_EDGE_SHAPE_H_
