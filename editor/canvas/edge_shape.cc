#include "editor/canvas/edge_shape.h"

#include <algorithm>
#include <cmath>

namespace coppice::editor {
namespace {

constexpr int kSamples = 24;
constexpr float kTrunkInset = 10;    // of the trunk, left of the leaves
constexpr float kTrunkTop = 28;      // below the parent, where the trunk begins
constexpr float kHeaderMiddle = 12;  // where a branch meets its leaf

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

EdgeShape Curve(Point a, Point d, Orientation orientation) {
  if (orientation == Orientation::kTopToBottom) {
    const float bend = (d.y - a.y) * 0.55F;
    return {a, {a.x, a.y + bend}, {d.x, d.y - bend}, d, {}};
  }
  const float bend = (d.x - a.x) * 0.5F;
  return {a, {a.x + bend, a.y}, {d.x - bend, d.y}, d, {}};
}

}  // namespace

EdgeShape ShapeOfEdge(const Box& parent, const Box& child, Link link, Orientation orientation,
                      float zoom) {
  if (orientation == Orientation::kLeftToRight) {
    return Curve({parent.max.x, parent.center().y}, {child.min.x, child.center().y}, orientation);
  }
  const Point start = {parent.center().x, parent.max.y};
  if (link != Link::kTrunk) return Curve(start, {child.center().x, child.min.y}, orientation);
  const Point top = {child.min.x - kTrunkInset * zoom, start.y + kTrunkTop * zoom};
  EdgeShape edge = Curve(start, top, orientation);
  const float y = child.min.y + kHeaderMiddle * zoom;
  edge.branch = {{top.x, y}, {child.min.x, y}};
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
