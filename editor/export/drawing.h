// A picture as a list of shapes and texts, for formats that know such things: SVG and PDF.
#ifndef COPPICE_EDITOR_EXPORT_DRAWING_H_
#define COPPICE_EDITOR_EXPORT_DRAWING_H_

#include <string>
#include <vector>

#include "editor/canvas/paint/pen.h"

namespace coppice::editor {

struct DrawnItem {
  enum class Kind : std::uint8_t {
    kFill,
    kStroke,
    kLine,
    kCurve,  ///< four points
    kDisc,   ///< center, size
    kBox,    ///< two corners, size is the rounding
    kText,   ///< left end of the base line, size of the em
    kClip,   ///< two corners; the items until kUnclip lie inside
    kUnclip
  };
  Kind kind = Kind::kFill;
  std::vector<Point> points;
  Color color = 0;
  float size = 0;  ///< thickness, radius, rounding or em
  std::string text;
  Face face = Face::kSans;
  float width = 0;  ///< of a text
};

struct Drawing {
  Point size;
  Color background = 0xFFFFFFFF;
  std::vector<DrawnItem> items;  ///< from below to above
};

/// Fills a Drawing.
class DrawingPen : public Pen {
 public:
  DrawingPen(const Ui& used, Drawing& drawing) : Pen(used), drawing_(drawing) {}

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
  void Add(DrawnItem::Kind kind, std::vector<Point> points, Color color, float size);
  Drawing& drawing_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_DRAWING_H_
