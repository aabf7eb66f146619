// What the painters of nodes and edges draw with. The canvas gives them a pen that fills an
// ImDrawList; an export gives them one that keeps lines and texts, for SVG and PDF. So a picture on
// paper is the picture on the screen.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_PEN_H_
#define COPPICE_EDITOR_CANVAS_PAINT_PEN_H_

#include <string_view>

#include "editor/canvas/paint/shapes.h"
#include "editor/theme/ui.h"

namespace coppice::editor {

class Pen {
 public:
  explicit Pen(const Ui& used) : ui(used) {}
  virtual ~Pen() = default;
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  /// A convex outline.
  virtual void Fill(const Outline& outline, Color color) = 0;
  virtual void Stroke(const Outline& outline, Color color, float thickness) = 0;
  /// An open line.
  virtual void Line(const Outline& points, Color color, float thickness) = 0;
  /// A cubic Bezier curve.
  virtual void Curve(Point a, Point b, Point c, Point d, Color color, float thickness) = 0;
  virtual void Disc(Point center, float radius, Color color) = 0;
  virtual void FillBox(const Box& box, Color color, float rounding = 0) = 0;
  /// Nothing is drawn outside of the box until PopClip().
  virtual void PushClip(const Box& box) = 0;
  virtual void PopClip() = 0;

  void FrameBox(const Box& box, Color color, float rounding = 0, float thickness = 1);
  void Dash(const Outline& outline, Color color, float thickness, float dash);
  /// Slanted lines inside the box.
  void Hatch(const Box& box, Color color, float distance);

  float Width(std::string_view text, const TextStyle& style) const { return ui.Width(text, style); }
  void Text(Point at, std::string_view text, const TextStyle& style);
  /// In the vertical middle of a row. Cuts what is wider than `width` and ends it with an ellipsis;
  /// width 0: no limit.
  void RowText(Point at, float row_height, std::string_view text, const TextStyle& style,
               float width = 0);

  const Ui& ui;
  float opacity = 1;  ///< of everything that is drawn

 protected:
  /// With the top left corner at `at`; `font` is one of ui.fonts.
  virtual void Glyphs(Point at, std::string_view text, Face face, const ImFont& font,
                      Color color) = 0;
  Color Ink(Color color) const { return opacity < 1 ? Fade(color, opacity) : color; }
};

/// Draws into a list of Dear ImGui.
class ScreenPen : public Pen {
 public:
  ScreenPen(const Ui& used, ImDrawList& list) : Pen(used), list_(list) {}

  void Fill(const Outline& outline, Color color) override;
  void Stroke(const Outline& outline, Color color, float thickness) override;
  void Line(const Outline& points, Color color, float thickness) override;
  void Curve(Point a, Point b, Point c, Point d, Color color, float thickness) override;
  void Disc(Point center, float radius, Color color) override;
  void FillBox(const Box& box, Color color, float rounding = 0) override;
  void PushClip(const Box& box) override;
  void PopClip() override;

 protected:
  void Glyphs(Point at, std::string_view text, Face face, const ImFont& font, Color color) override;

 private:
  ImDrawList& list_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_PEN_H_
