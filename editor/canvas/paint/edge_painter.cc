#include "editor/canvas/paint/edge_painter.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/paint/node_marks.h"
#include "editor/canvas/paint/node_painter.h"
#include "editor/canvas/paint/status_look.h"

namespace coppice::editor {
namespace {

constexpr float kDotDistance = 30;  // pixels at zoom 1
constexpr float kDotSpeed = 150;    // pixels per second at zoom 1
constexpr float kDash = 9;
constexpr float kTiny = 1.5F;  // height of a block; pixels at scale 1

float Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Calls `visit(point)` every `gap` pixels along the line, from `first` on.
template <typename Visit>
void Walk(const std::vector<Point>& points, float first, float gap, Visit visit) {
  float next = first;
  float walked = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const float length = Distance(points[i - 1], points[i]);
    for (; next <= walked + length; next += gap) {
      const float t = length > 0 ? (next - walked) / length : 0;
      visit(points[i - 1] + (points[i] - points[i - 1]) * t);
    }
    walked += length;
  }
}

Outline OutlineOf(const std::vector<Point>& points) {
  Outline outline;
  outline.reserve(points.size());
  for (const Point point : points) outline.push_back(ToIm(point));
  return outline;
}

class EdgePainter {
 public:
  EdgePainter(Pen& pen, const EdgeLook& look)
      : pen_(pen), look_(look), zoom_(look.ends.zoom), edge_(ShapeOfEdge(look.ends)) {}

  void Paint() {
    const float before = pen_.opacity;
    pen_.opacity *= look_.strength;
    const bool running = look_.state.status == Status::kRunning;
    PaintLine(Colour(), Thickness());
    if (running && !look_.offline) PaintMotion(Mix(Colour(), 0xFFFFFFFF, 0.45F));
    if (look_.number != 0 && DetailFor(zoom_, pen_.ui.scale) == Detail::kFull) PaintNumber();
    pen_.opacity = before;
  }

 private:
  Color Colour() const {
    const Palette& colors = pen_.ui.palette;
    const bool changed = look_.change != Change::kNone && look_.change != Change::kChanged;
    const Color at_rest = changed ? ColorOf(colors, look_.change) : colors.edge;
    const Color color = StatusColor(colors, look_.state, at_rest);
    if (look_.offline) return Mix(color, colors.edge, 0.6F);
    if (!IsTrail(look_.state)) return color;
    return Fade(color, StatusStrength(look_.state, pen_.ui.clock));
  }

  float Thickness() const {
    const bool running = look_.state.status == Status::kRunning;
    const float thick = running ? 3.0F : look_.state.status != Status::kIdle ? 2.0F : 1.5F;
    const float scale = pen_.ui.scale;
    return std::max(scale, thick * std::min(zoom_, 1.2F * scale));
  }

  void PaintLine(Color color, float thick) {
    if (!look_.stem) return pen_.Line(OutlineOf(PartBehindStem(edge_, look_.ends)), color, thick);
    pen_.Curve(edge_.a, edge_.b, edge_.c, edge_.d, color, thick);
    if (edge_.branch.empty()) return;
    std::vector<Point> line = {edge_.d};
    line.insert(line.end(), edge_.branch.begin(), edge_.branch.end());
    pen_.Line(OutlineOf(line), color, thick);
  }

  // Dots that walk in the direction of the tick; if nothing moves, dashes.
  void PaintMotion(Color color) {
    const std::vector<Point> points = PointsAlong(edge_);
    const float gap = kDotDistance * zoom_;
    if (!pen_.ui.moves()) {
      const float half = kDash * zoom_ / 2;
      Walk(points, gap / 2, gap, [&](Point at) {
        pen_.FillBox({at - Point{half / 2, half / 2}, at + Point{half / 2, half / 2}}, color);
      });
      return;
    }
    const auto phase = static_cast<float>(std::fmod(pen_.ui.now * kDotSpeed, kDotDistance)) * zoom_;
    Walk(points, phase, gap, [&](Point at) { pen_.Disc(at, std::max(2.0F, 4 * zoom_), color); });
  }

  void PaintNumber() {
    const Link link = look_.ends.link;
    const bool down = look_.ends.orientation == Orientation::kTopToBottom &&
                      (link == Link::kCurve || link == Link::kRow);
    const std::string text = std::to_string(look_.number);
    const TextStyle style{Face::kSans, 9 * zoom_ / pen_.ui.scale, pen_.ui.palette.text_dim};
    Point at = edge_.arrival + (down ? Point{5, -14} : Point{-12, -14}) * zoom_;
    // On the outer side of the bend, where the line does not come by.
    if (down && edge_.arrival.x < edge_.a.x) at.x -= pen_.Width(text, style) + 10 * zoom_;
    pen_.Text(at, text, style);
  }

  Pen& pen_;
  const EdgeLook& look_;
  const float zoom_;
  const EdgeShape edge_;
};

}  // namespace

void PaintEdge(Pen& pen, const EdgeLook& look) {
  if (look.ends.link != Link::kNone) EdgePainter(pen, look).Paint();
}

void PaintFarEdge(Pen& pen, const EdgeLook& look) {
  // So many lines between so small boxes would hide these.
  const bool tiny = look.ends.child.height() < kTiny * pen.ui.scale;
  if (tiny && look.state.status == Status::kIdle) return;
  const Color color =
      Fade(StatusColor(pen.ui.palette, look.state, pen.ui.palette.edge), 0.7F * look.strength);
  std::vector<Point> line;
  if (!HasStem(look.ends)) {
    line = {look.ends.parent.center(), look.ends.child.center()};
  } else if (const EdgeShape edge = ShapeOfEdge(look.ends); look.stem) {
    line = {edge.a, edge.d};
    line.insert(line.end(), edge.branch.begin(), edge.branch.end());
  } else {
    line = PartBehindStem(edge, look.ends);
  }
  pen.Line(OutlineOf(line), color, pen.ui.scale);
}

}  // namespace coppice::editor
