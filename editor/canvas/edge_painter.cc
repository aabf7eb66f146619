#include "editor/canvas/edge_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::editor {
namespace {

constexpr float kDotDistance = 30;  // pixels at zoom 1
constexpr float kDotSpeed = 45;     // pixels per second at zoom 1
constexpr int kSamples = 24;

struct Curve {
  Point a, b, c, d;  // a cubic Bezier curve
};

Curve CurveOf(const EdgeLook& look) {
  if (look.orientation == Orientation::kTopToBottom) {
    const Point a = {look.parent.center().x, look.parent.max.y};
    const Point d = {look.child.center().x, look.child.min.y};
    const float bend = (d.y - a.y) * 0.55F;
    return {a, {a.x, a.y + bend}, {d.x, d.y - bend}, d};
  }
  const Point a = {look.parent.max.x, look.parent.center().y};
  const Point d = {look.child.min.x, look.child.center().y};
  const float bend = (d.x - a.x) * 0.5F;
  return {a, {a.x + bend, a.y}, {d.x - bend, d.y}, d};
}

Point On(const Curve& curve, float t) {
  const float s = 1 - t;
  return curve.a * (s * s * s) + curve.b * (3 * s * s * t) + curve.c * (3 * s * t * t) +
         curve.d * (t * t * t);
}

float Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

void PaintDots(ImDrawList& list, const Curve& curve, Color color, float zoom, double now) {
  std::array<Point, kSamples + 1> points;
  for (int i = 0; i <= kSamples; ++i) {
    points[static_cast<std::size_t>(i)] = On(curve, static_cast<float>(i) / kSamples);
  }
  const float gap = kDotDistance * zoom;
  const auto phase = static_cast<float>(std::fmod(now * kDotSpeed * zoom, gap));
  float next = phase;
  float walked = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const float length = Distance(points[i - 1], points[i]);
    for (; next <= walked + length; next += gap) {
      const float t = length > 0 ? (next - walked) / length : 0;
      const Point at = points[i - 1] + (points[i] - points[i - 1]) * t;
      list.AddCircleFilled({at.x, at.y}, std::max(2.0F, 4 * zoom), color, 12);
    }
    walked += length;
  }
}

}  // namespace

void PaintEdge(const Ui& ui, ImDrawList& list, const EdgeLook& look) {
  const Palette& colors = ui.palette;
  const Curve curve = CurveOf(look);
  const bool running = look.state.status == Status::kRunning;
  const bool trail = look.state.status == Status::kIdle && look.state.before != Status::kIdle;
  Color color = StatusColor(colors, look.state, colors.edge);
  if (look.offline) color = Mix(color, colors.edge, 0.6F);
  if (trail) color = Fade(color, 0.5F);
  float thick = running ? 3.0F : look.state.status != Status::kIdle ? 2.0F : 1.5F;
  thick = std::max(1.0F, thick * std::min(look.zoom, 1.2F));
  list.AddBezierCubic(ToIm(curve.a), ToIm(curve.b), ToIm(curve.c), ToIm(curve.d), color, thick);
  if (running && !look.offline) {
    PaintDots(list, curve, Mix(color, 0xFFFFFFFF, 0.45F), look.zoom, ui.now);
  }
  if (look.number == 0 || DetailFor(look.zoom) != Detail::kFull) return;
  const Point beside = look.orientation == Orientation::kTopToBottom
                           ? Point{5 * look.zoom, -14 * look.zoom}
                           : Point{-12 * look.zoom, -14 * look.zoom};
  ui.Text(list, curve.d + beside, std::to_string(look.number),
          {Face::kSans, 9 * look.zoom / ui.scale, Fade(colors.text_dim, 0.75F)});
}

}  // namespace coppice::editor
