#include "editor/export/pdf.h"

#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <set>

namespace coppice::editor {
namespace {

constexpr float kPointsPerPixel = 0.75F;
constexpr float kLongestPage = 14400;  // PDF 1.4, appendix C
constexpr float kCircle = 0.5522847F;  // of a quarter circle as a Bezier curve

std::string Number(float value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f ", static_cast<double>(value));
  return text;
}

// Of a byte: 0 to 1.
std::string Share(std::uint32_t byte) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4f ", static_cast<double>(byte) / 255);
  return text;
}

std::string At(Point p) { return Number(p.x) + Number(p.y); }

// The page's marks, in the coordinates of the drawing.
class Page {
 public:
  explicit Page(const Glyphs& glyphs) : glyphs_(glyphs) {}

  void Add(const DrawnItem& item) {
    switch (item.kind) {
      case DrawnItem::Kind::kFill:
        Way(item.points);
        Paint(item, "h f\n");
        break;
      case DrawnItem::Kind::kStroke:
        Way(item.points);
        Paint(item, "s\n");
        break;
      case DrawnItem::Kind::kLine:
        Way(item.points);
        Paint(item, "S\n");
        break;
      case DrawnItem::Kind::kCurve:
        way_ = At(item.points[0]) + "m " + Curve(item.points[1], item.points[2], item.points[3]);
        Paint(item, "S\n");
        break;
      case DrawnItem::Kind::kDisc:
        Round({item.points[0] - Point{item.size, item.size},
               item.points[0] + Point{item.size, item.size}},
              item.size);
        Paint(item, "f\n");
        break;
      case DrawnItem::Kind::kBox:
        Round({item.points[0], item.points[1]}, item.size);
        Paint(item, "f\n");
        break;
      case DrawnItem::Kind::kText:
        Text(item);
        Paint(item, "f\n");
        break;
      case DrawnItem::Kind::kClip:
        content_ += "q ";
        Round({item.points[0], item.points[1]}, 0);
        content_ += way_ + "W n\n";
        break;
      case DrawnItem::Kind::kUnclip:
        content_ += "Q\n";
        break;
    }
  }

  const std::string& content() const { return content_; }
  const std::set<std::uint32_t>& alphas() const { return alphas_; }

 private:
  static std::string Curve(Point b, Point c, Point d) { return At(b) + At(c) + At(d) + "c "; }

  void Way(const std::vector<Point>& points) {
    way_.clear();
    for (std::size_t i = 0; i < points.size(); ++i) way_ += At(points[i]) + (i == 0 ? "m " : "l ");
  }

  void Round(const Box& box, float rounding) {
    const float r = std::min({rounding, box.width() / 2, box.height() / 2});
    if (r <= 0) {
      way_ = At(box.min) + Number(box.width()) + Number(box.height()) + "re ";
      return;
    }
    const float k = r * (1 - kCircle);
    const auto [left, top] = box.min;
    const auto [right, bottom] = box.max;
    way_ = At({left + r, top}) + "m " + At({right - r, top}) + "l " +
           Curve({right - k, top}, {right, top + k}, {right, top + r}) + At({right, bottom - r}) +
           "l " + Curve({right, bottom - k}, {right - k, bottom}, {right - r, bottom}) +
           At({left + r, bottom}) + "l " +
           Curve({left + k, bottom}, {left, bottom - k}, {left, bottom - r}) + At({left, top + r}) +
           "l " + Curve({left, top + k}, {left + k, top}, {left + r, top});
  }

  void Text(const DrawnItem& item) {
    way_.clear();
    for (const GlyphStep& step :
         glyphs_.OutlineOf(item.text, item.face, item.size, item.points[0], item.width)) {
      if (step.kind == GlyphStep::Kind::kMove) way_ += At(step.to) + "m ";
      if (step.kind == GlyphStep::Kind::kLine) way_ += At(step.to) + "l ";
      if (step.kind == GlyphStep::Kind::kCurve) way_ += Curve(step.b, step.c, step.to);
    }
  }

  void Paint(const DrawnItem& item, const char* how) {
    if (way_.empty()) return;
    const std::uint32_t alpha = item.color >> 24;
    alphas_.insert(alpha);
    std::string rgb;
    for (const int shift : {0, 8, 16}) {
      rgb += Share((item.color >> shift) & 0xFFU);
    }
    content_ += "/A" + std::to_string(alpha) + " gs " + rgb + "rg " + rgb + "RG " +
                Number(item.size) + "w " + way_ + how;
  }

  const Glyphs& glyphs_;
  std::string content_;
  std::string way_;
  std::set<std::uint32_t> alphas_;
};

std::string Compressed(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string result(size, '\0');
  compress(reinterpret_cast<Bytef*>(result.data()), &size,
           reinterpret_cast<const Bytef*>(text.data()), text.size());
  result.resize(size);
  return result;
}

// The objects of a file, numbered from 1, and the table of where they begin.
class File {
 public:
  void Add(const std::string& object) {
    places_.push_back(text_.size());
    text_ += std::to_string(places_.size()) + " 0 obj\n" + object + "\nendobj\n";
  }

  std::string Finish() {
    const std::string count = std::to_string(places_.size() + 1);
    const std::size_t table = text_.size();
    text_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
    for (const std::size_t place : places_) {
      char line[32];
      std::snprintf(line, sizeof(line), "%010zu 00000 n \n", place);
      text_ += line;
    }
    return text_ + "trailer\n<</Size " + count + "/Root 1 0 R>>\nstartxref\n" +
           std::to_string(table) + "\n%%EOF\n";
  }

 private:
  std::string text_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
  std::vector<std::size_t> places_;
};

}  // namespace

std::string ToPdf(const Drawing& drawing, const Glyphs& glyphs) {
  Page page(glyphs);
  page.Add(
      {DrawnItem::Kind::kBox, {{0, 0}, drawing.size}, drawing.background, 0, {}, Face::kSans, 0});
  for (const DrawnItem& item : drawing.items) page.Add(item);
  const float longest = std::max({drawing.size.x, drawing.size.y, 1.0F});
  const float scale = std::min(kPointsPerPixel, kLongestPage / longest);
  char matrix[96];  // y of a PDF grows upwards
  std::snprintf(matrix, sizeof(matrix), "%.5f 0 0 %.5f 0 %.2f cm\n", static_cast<double>(scale),
                static_cast<double>(-scale), static_cast<double>(drawing.size.y * scale));
  const std::string content = Compressed(matrix + page.content());
  std::string alphas;
  for (const std::uint32_t alpha : page.alphas()) {
    const std::string share = Share(alpha);
    alphas += "/A" + std::to_string(alpha) + "<</ca " + share + "/CA " + share + ">>";
  }
  File file;
  file.Add("<</Type/Catalog/Pages 2 0 R>>");
  file.Add("<</Type/Pages/Kids[3 0 R]/Count 1>>");
  file.Add("<</Type/Page/Parent 2 0 R/MediaBox[0 0 " + Number(drawing.size.x * scale) +
           Number(drawing.size.y * scale) + "]/Contents 4 0 R/Resources<</ExtGState<<" + alphas +
           ">>>>>>");
  file.Add("<</Length " + std::to_string(content.size()) + "/Filter/FlateDecode>>\nstream\n" +
           content + "\nendstream");
  return file.Finish();
}

}  // namespace coppice::editor
