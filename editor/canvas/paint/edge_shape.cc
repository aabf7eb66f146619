// A line is painted, pointed at, exported and tested; all of them ask here, so that none of them
// has an idea of its own of where it runs. From left to right is the same geometry with x and y
// exchanged, where it can be.
#include "editor/canvas/paint/edge_shape.h"

#include <algorithm>
#include <cmath>

namespace coppice::editor {
namespace {

constexpr int kSamples = 24;
constexpr float kTrunkInset = 10;    // of the trunk, left of the leaves
constexpr float kTrunkTop = 28;      // below the parent, where the trunk begins
constexpr float kHeaderMiddle = 12;  // where a branch meets its leaf
constexpr float kRowTrunk = 8;       // of the line along rows, from the left side of their parent
constexpr float kAboveRow = 10;      // where a line runs to the children of a row
constexpr float kRadius = 8;         // of corners
constexpr float kLeastRadius = 2;    // pixels; smaller corners are sharp
constexpr std::size_t kMostPoints = 12;  // of a branch
constexpr float kThickest = 4;           // half of a line [pixels]

Point OnCurve(const EdgeShape& edge, float t) {
  const float s = 1 - t;
  return edge.a * (s * s * s) + edge.b * (3 * s * s * t) + edge.c * (3 * s * t * t) +
         edge.d * (t * t * t);
}

float DistanceToSegment(Point from, Point to, Point point) {
  const Point way = to - from;
  const float square = way.x * way.x + way.y * way.y;
  const Point start = point - from;
  const float t =
      square > 0 ? std::clamp((start.x * way.x + start.y * way.y) / square, 0.0F, 1.0F) : 0;
  const Point nearest = from + way * t;
  return std::hypot(point.x - nearest.x, point.y - nearest.y);
}

Point Flipped(Point p) { return {p.y, p.x}; }
Box Flipped(const Box& box) { return {Flipped(box.min), Flipped(box.max)}; }

EdgeShape Curve(Point a, Point d, Orientation orientation) {
  if (orientation == Orientation::kTopToBottom) {
    const float bend = (d.y - a.y) * 0.55F;
    return {a, {a.x, a.y + bend}, {d.x, d.y - bend}, d, {}, d};
  }
  const float bend = (d.x - a.x) * 0.5F;
  return {a, {a.x + bend, a.y}, {d.x - bend, d.y}, d, {}, d};
}

// Round a corner, from `radius` before it to `radius` behind it.
void AddCorner(std::vector<Point>& line, Point from, Point corner, Point to, float radius) {
  const Point start = corner + from * radius;
  const Point end = corner + to * radius;
  line.push_back(start);
  if (radius < kLeastRadius) return;
  for (const float t : {0.25F, 0.5F, 0.75F}) {
    const float s = 1 - t;
    line.push_back(start * (s * s) + corner * (2 * s * t) + end * (t * t));
  }
  line.push_back(end);
}

// Down along the rows, to the side above one of them, and down to `x`. Top to bottom.
EdgeShape WayIntoRow(const Box& parent, float row, float x, float zoom) {
  const Point start = {parent.min.x + kRowTrunk * zoom, parent.max.y};
  const float y = row - kAboveRow * zoom;
  const float radius =
      std::max(0.0F, std::min({kRadius * zoom, (y - start.y) / 2, std::abs(x - start.x) / 2}));
  const Point d = {start.x, y - radius};
  EdgeShape edge = {
      start, start + (d - start) * (1 / 3.0F), start + (d - start) * (2 / 3.0F), d, {}, {x, row}};
  edge.branch.reserve(kMostPoints);
  AddCorner(edge.branch, {0, -1}, {start.x, y}, {1, 0}, radius);
  edge.branch.erase(edge.branch.begin());  // d
  AddCorner(edge.branch, {-1, 0}, {x, y}, {0, 1}, radius);
  return edge;
}

void Flip(EdgeShape& edge) {
  for (Point* point : {&edge.a, &edge.b, &edge.c, &edge.d, &edge.arrival}) *point = Flipped(*point);
  for (Point& point : edge.branch) point = Flipped(point);
}

// The middle of a box without the note on it.
Point MiddleOf(const Box& box, float note) {
  return Box{{box.min.x, box.min.y + note}, box.max}.center();
}

// From left to right, a child is met in the middle of its left side.
EdgeShape ShapeAcross(const EdgeEnds& ends) {
  const Point middle = MiddleOf(ends.child, ends.child_note);
  if (ends.link != Link::kRow) {
    return Curve({ends.parent.max.x, MiddleOf(ends.parent, ends.parent_note).y},
                 {ends.child.min.x, middle.y}, ends.orientation);
  }
  EdgeShape edge = WayIntoRow(Flipped(ends.parent), ends.child.min.x, middle.y, ends.zoom);
  edge.branch.push_back(edge.arrival);
  Flip(edge);
  return edge;
}

bool IsInRow(const EdgeEnds& ends) { return ends.link == Link::kRow; }

// From left to right, nothing stands in columns.
bool IsOnTrunk(const EdgeEnds& ends) {
  return ends.link == Link::kTrunk && ends.orientation == Orientation::kTopToBottom;
}

Box Thick(Point a, Point b) {
  const Box box = Union({a, a}, {b, b});
  return {box.min - Point{kThickest, kThickest}, box.max + Point{kThickest, kThickest}};
}

// Top to bottom.
EdgeBounds BoundsInRow(const Box& parent, const Box& child, const EdgeEnds& ends) {
  const float x = parent.min.x + kRowTrunk * ends.zoom;
  const float y = child.min.y - kAboveRow * ends.zoom;
  const Box child_and_trunk = {child.min - Point{kTrunkInset * ends.zoom, 0}, child.max};
  return {Thick({x, parent.max.y}, {x, y}),
          Union(Thick({x, y - kRadius * ends.zoom}, {x, y}), child_and_trunk), x};
}

}  // namespace

bool HasStem(const EdgeEnds& ends) { return IsInRow(ends) || IsOnTrunk(ends); }

std::vector<Point> PartBehindStem(const EdgeShape& edge, const EdgeEnds& ends) {
  std::vector<Point> part;
  part.reserve(kMostPoints);
  if (!IsOnTrunk(ends)) part.push_back(edge.d);
  part.insert(part.end(), edge.branch.begin(), edge.branch.end());
  return part;
}

EdgeBounds BoundsOf(const EdgeEnds& ends) {
  if (IsInRow(ends) && ends.orientation == Orientation::kLeftToRight) {
    const EdgeBounds flipped = BoundsInRow(Flipped(ends.parent), Flipped(ends.child), ends);
    return {Flipped(flipped.stem), Flipped(flipped.rest), flipped.lane};
  }
  if (IsInRow(ends)) return BoundsInRow(ends.parent, ends.child, ends);
  if (!IsOnTrunk(ends)) {
    const Box all = Union(ends.parent, ends.child);
    return {all, all, 0};
  }
  const Point trunk = {ends.child.min.x - kTrunkInset * ends.zoom, ends.child.max.y};
  const Point start = {ends.parent.center().x, ends.parent.max.y};
  return {Thick(start, trunk), Union(Thick(trunk, trunk), ends.child), trunk.x};
}

EdgeShape ShapeOfEdge(const EdgeEnds& ends) {
  if (ends.orientation == Orientation::kLeftToRight) return ShapeAcross(ends);
  const Box& child = ends.child;
  const float zoom = ends.zoom;
  const Point start = {ends.parent.center().x, ends.parent.max.y};
  const Point top = {child.center().x, child.min.y};
  const float trunk = child.min.x - kTrunkInset * zoom;
  const Point leaf = {child.min.x, child.min.y + ends.child_note + kHeaderMiddle * zoom};
  EdgeShape edge;
  switch (ends.link) {
    case Link::kRow:
      edge = WayIntoRow(ends.parent, top.y, top.x, zoom);
      edge.branch.push_back(edge.arrival);
      break;
    case Link::kTrunk:
      edge = Curve(start, {trunk, start.y + kTrunkTop * zoom}, ends.orientation);
      break;
    default:
      edge = Curve(start, top, ends.orientation);
      break;
  }
  if (ends.link == Link::kTrunk) {
    edge.branch.push_back({trunk, leaf.y});
    edge.branch.push_back(leaf);
    edge.arrival = leaf;
  } else if (ends.child_note > 0) {
    edge.branch.push_back(top + Point{0, ends.child_note});  // behind the note
  }
  return edge;
}

std::vector<Point> PointsAlong(const EdgeShape& edge) {
  std::vector<Point> points;
  points.reserve(kSamples + 3);
  for (int i = 0; i <= kSamples; ++i) {
    points.push_back(OnCurve(edge, static_cast<float>(i) / kSamples));
  }
  points.insert(points.end(), edge.branch.begin(), edge.branch.end());
  return points;
}

float DistanceTo(const EdgeShape& edge, Point point) {
  const std::vector<Point> points = PointsAlong(edge);
  float least = 1e9F;
  for (std::size_t i = 1; i < points.size(); ++i) {
    least = std::min(least, DistanceToSegment(points[i - 1], points[i], point));
  }
  return least;
}

}  // namespace coppice::editor
