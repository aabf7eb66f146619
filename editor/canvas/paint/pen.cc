#include "editor/canvas/paint/pen.h"

#include <cmath>
#include <string>

namespace coppice::editor {

void Pen::FrameBox(const Box& box, Color color, float rounding, float thickness) {
  Stroke(RoundedBox(box, rounding), color, thickness);
}

void Pen::Dash(const Outline& outline, Color color, float thickness, float dash) {
  for (const Outline& line : DashesOf(outline, dash)) Line(line, color, thickness);
}

void Pen::Hatch(const Box& box, Color color, float distance) {
  PushClip(box);
  for (float x = box.min.x - box.height(); x < box.max.x; x += distance) {
    Line({{x, box.max.y}, {x + box.height(), box.min.y}}, color, 1.5F);
  }
  PopClip();
}

void Pen::Text(Point at, std::string_view text, const TextStyle& style) {
  if (text.empty()) return;
  const ImFont& font = *ui.fonts.For(text, style.face, style.size * ui.scale);
  Glyphs(at, text, style.face, font, style.color);
}

void Pen::RowText(Point at, float row_height, std::string_view text, const TextStyle& style,
                  float width) {
  const ImFont& font = *ui.fonts.For(text, style.face, style.size * ui.scale);
  at.y += (row_height - font.FontSize) / 2;
  if (width <= 0 || ui.Width(text, style) <= width) {
    Text(at, text, style);
  } else {
    Text(at, ui.Cut(text, style, width), style);
  }
}

void ScreenPen::Fill(const Outline& outline, Color color) {
  list_.AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), Ink(color));
}

void ScreenPen::Stroke(const Outline& outline, Color color, float thickness) {
  list_.AddPolyline(outline.data(), static_cast<int>(outline.size()), Ink(color),
                    ImDrawFlags_Closed, thickness);
}

void ScreenPen::Line(const Outline& points, Color color, float thickness) {
  list_.AddPolyline(points.data(), static_cast<int>(points.size()), Ink(color), 0, thickness);
}

void ScreenPen::Curve(Point a, Point b, Point c, Point d, Color color, float thickness) {
  list_.AddBezierCubic(ToIm(a), ToIm(b), ToIm(c), ToIm(d), Ink(color), thickness);
}

void ScreenPen::Disc(Point center, float radius, Color color) {
  list_.AddCircleFilled(ToIm(center), radius, Ink(color), radius > 6 ? 20 : 12);
}

void ScreenPen::FillBox(const Box& box, Color color, float rounding) {
  list_.AddRectFilled(ToIm(box.min), ToIm(box.max), Ink(color), rounding);
}

void ScreenPen::PushClip(const Box& box) { list_.PushClipRect(ToIm(box.min), ToIm(box.max), true); }

void ScreenPen::PopClip() { list_.PopClipRect(); }

void ScreenPen::Glyphs(Point at, std::string_view text, Face, const ImFont& font, Color color) {
  list_.AddText(&font, font.FontSize, {std::round(at.x), std::round(at.y)}, Ink(color), text.data(),
                text.data() + text.size());
}

}  // namespace coppice::editor
