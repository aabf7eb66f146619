// The way of a line from a parent to its child: a cubic Bezier curve, and for a leaf in a column a
// piece down the trunk and a branch to the leaf.
#ifndef COPPICE_EDITOR_CANVAS_EDGE_SHAPE_H_
#define COPPICE_EDITOR_CANVAS_EDGE_SHAPE_H_

#include <vector>

#include "editor/canvas/tree_layout.h"

namespace coppice::editor {

struct EdgeShape {
  Point a, b, c, d;           ///< the Bezier curve
  std::vector<Point> branch;  ///< from d on; empty if the curve ends at the child
};

/// `zoom` scales the distances of the trunk; 1 in the world.
EdgeShape ShapeOfEdge(const Box& parent, const Box& child, Link link, Orientation orientation,
                      float zoom);

/// Points along the whole edge, close enough to walk on.
std::vector<Point> PointsAlong(const EdgeShape& edge);

/// Distance of a point from the nearest place of the edge.
float DistanceTo(const EdgeShape& edge, Point point);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_EDGE_SHAPE_H_
