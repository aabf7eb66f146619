#include "editor/export/drawing.h"

#include <utility>

namespace coppice::editor {
namespace {

// Dear ImGui's size of a font is from its highest to its lowest place; the em of DejaVu is smaller.
constexpr float kEmOfSize = 2048.0F / (1901 + 483);

std::vector<Point> ToPoints(const Outline& outline) {
  std::vector<Point> points;
  points.reserve(outline.size());
  for (const ImVec2& point : outline) points.push_back(FromIm(point));
  return points;
}

}  // namespace

void DrawingPen::Add(DrawnItem::Kind kind, std::vector<Point> points, Color color, float size) {
  drawing_.items.push_back({kind, std::move(points), Ink(color), size, {}, Face::kSans, 0});
}

void DrawingPen::Fill(const Outline& outline, Color color) {
  Add(DrawnItem::Kind::kFill, ToPoints(outline), color, 0);
}

void DrawingPen::Stroke(const Outline& outline, Color color, float thickness) {
  Add(DrawnItem::Kind::kStroke, ToPoints(outline), color, thickness);
}

void DrawingPen::Line(const Outline& points, Color color, float thickness) {
  Add(DrawnItem::Kind::kLine, ToPoints(points), color, thickness);
}

void DrawingPen::Curve(Point a, Point b, Point c, Point d, Color color, float thickness) {
  Add(DrawnItem::Kind::kCurve, {a, b, c, d}, color, thickness);
}

void DrawingPen::Disc(Point center, float radius, Color color) {
  Add(DrawnItem::Kind::kDisc, {center}, color, radius);
}

void DrawingPen::FillBox(const Box& box, Color color, float rounding) {
  Add(DrawnItem::Kind::kBox, {box.min, box.max}, color, rounding);
}

void DrawingPen::PushClip(const Box& box) { Add(DrawnItem::Kind::kClip, {box.min, box.max}, 0, 0); }

void DrawingPen::PopClip() { Add(DrawnItem::Kind::kUnclip, {}, 0, 0); }

void DrawingPen::Glyphs(Point at, std::string_view text, Face face, const ImFont& font,
                        Color color) {
  Add(DrawnItem::Kind::kText, {at + Point{0, font.Ascent}}, color, font.FontSize * kEmOfSize);
  DrawnItem& item = drawing_.items.back();
  item.text = text;
  item.face = face;
  item.width = font.CalcTextSizeA(font.FontSize, 1e9F, 0, text.data(), text.data() + text.size()).x;
}

}  // namespace coppice::editor
