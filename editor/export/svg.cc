#include "editor/export/svg.h"

#include <cstdio>

namespace coppice::editor {
namespace {

std::string Number(float value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", static_cast<double>(value));
  std::string number = text;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number == "-0" ? "0" : number;
}

std::string At(Point p) { return Number(p.x) + " " + Number(p.y); }

// `name`="#rrggbb", with name-opacity if it is not opaque.
std::string Paint(const char* name, Color color) {
  char text[16];
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", color & 0xFFU, (color >> 8) & 0xFFU,
                (color >> 16) & 0xFFU);
  std::string paint = std::string(" ") + name + "=\"" + text + "\"";
  const std::uint32_t alpha = color >> 24;
  if (alpha < 255) {
    paint +=
        std::string(" ") + name + "-opacity=\"" + Number(static_cast<float>(alpha) / 255) + "\"";
  }
  return paint;
}

// As XML 1.0 allows it: control characters become blanks.
std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

class Writer {
 public:
  explicit Writer(const Glyphs& glyphs) : glyphs_(glyphs) {}

  std::string Write(const Drawing& drawing) {
    const std::string width = Number(drawing.size.x);
    const std::string height = Number(drawing.size.y);
    svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height + "\">\n<rect width=\"" + width +
           "\" height=\"" + height + "\"" + Paint("fill", drawing.background) + "/>\n";
    for (const DrawnItem& item : drawing.items) Add(item);
    return svg_ + "</svg>\n";
  }

 private:
  void Add(const DrawnItem& item) {
    switch (item.kind) {
      case DrawnItem::Kind::kFill:
        svg_ += "<polygon" + Points(item) + Paint("fill", item.color) + "/>\n";
        break;
      case DrawnItem::Kind::kStroke:
        svg_ += "<polygon" + Points(item) + " fill=\"none\"" + Stroke(item) + "/>\n";
        break;
      case DrawnItem::Kind::kLine:
        svg_ += "<polyline" + Points(item) + " fill=\"none\"" + Stroke(item) + "/>\n";
        break;
      case DrawnItem::Kind::kCurve:
        svg_ += "<path d=\"M" + At(item.points[0]) + "C" + At(item.points[1]) + " " +
                At(item.points[2]) + " " + At(item.points[3]) + "\" fill=\"none\"" + Stroke(item) +
                "/>\n";
        break;
      case DrawnItem::Kind::kDisc:
        svg_ += "<circle cx=\"" + Number(item.points[0].x) + "\" cy=\"" + Number(item.points[0].y) +
                "\" r=\"" + Number(item.size) + "\"" + Paint("fill", item.color) + "/>\n";
        break;
      case DrawnItem::Kind::kBox:
        svg_ += "<rect" + Corners(item) + Rounding(item) + Paint("fill", item.color) + "/>\n";
        break;
      case DrawnItem::Kind::kText:
        AddText(item);
        break;
      case DrawnItem::Kind::kClip:
        AddClip(item);
        break;
      case DrawnItem::Kind::kUnclip:
        svg_ += "</g>\n";
        break;
    }
  }

  static std::string Points(const DrawnItem& item) {
    std::string points = " points=\"";
    for (const Point point : item.points) points += At(point) + " ";
    points.back() = '"';
    return points;
  }

  static std::string Stroke(const DrawnItem& item) {
    return Paint("stroke", item.color) + " stroke-width=\"" + Number(item.size) + "\"";
  }

  static std::string Corners(const DrawnItem& item) {
    const Box box = {item.points[0], item.points[1]};
    return " x=\"" + Number(box.min.x) + "\" y=\"" + Number(box.min.y) + "\" width=\"" +
           Number(box.width()) + "\" height=\"" + Number(box.height()) + "\"";
  }

  static std::string Rounding(const DrawnItem& item) {
    return item.size > 0 ? " rx=\"" + Number(item.size) + "\"" : "";
  }

  void AddText(const DrawnItem& item) {
    const std::vector<std::uint32_t> codes = CodePoints(item.text);
    if (!codes.empty() && IsIcon(codes.front())) return AddOutline(item);
    const char* family = item.face == Face::kMono ? "'DejaVu Sans Mono',Menlo,Consolas,monospace"
                                                  : "'DejaVu Sans',Verdana,sans-serif";
    svg_ += "<text x=\"" + Number(item.points[0].x) + "\" y=\"" + Number(item.points[0].y) +
            "\" font-family=\"" + family + "\" font-size=\"" + Number(item.size) + "\"" +
            (item.face == Face::kBold ? " font-weight=\"bold\"" : "") + " textLength=\"" +
            Number(item.width) + "\" lengthAdjust=\"spacingAndGlyphs\" xml:space=\"preserve\"" +
            Paint("fill", item.color) + ">" + Escaped(item.text) + "</text>\n";
  }

  void AddOutline(const DrawnItem& item) {
    svg_ += "<path d=\"";
    for (const GlyphStep& step :
         glyphs_.OutlineOf(item.text, item.face, item.size, item.points[0], item.width)) {
      if (step.kind == GlyphStep::Kind::kMove) svg_ += "M" + At(step.to);
      if (step.kind == GlyphStep::Kind::kLine) svg_ += "L" + At(step.to);
      if (step.kind == GlyphStep::Kind::kCurve) {
        svg_ += "C" + At(step.b) + " " + At(step.c) + " " + At(step.to);
      }
    }
    svg_ += "\"" + Paint("fill", item.color) + "/>\n";
  }

  void AddClip(const DrawnItem& item) {
    const std::string id = "c" + std::to_string(++clips_);
    svg_ += "<clipPath id=\"" + id + "\"><rect" + Corners(item) +
            "/></clipPath><g clip-path=\"url(#" + id + ")\">\n";
  }

  const Glyphs& glyphs_;
  std::string svg_;
  int clips_ = 0;
};

}  // namespace

std::string ToSvg(const Drawing& drawing, const Glyphs& glyphs) {
  return Writer(glyphs).Write(drawing);
}

}  // namespace coppice::editor
