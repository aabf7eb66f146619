#include "editor/export/glyphs.h"

#include <imgui.h>
#include <stb/stb_truetype.h>

#include <array>
#include <fstream>
#include <iterator>
#include <string>

#include "editor/theme/font_files.h"

namespace coppice::editor {
namespace {

constexpr std::uint32_t kNoCharacter = 0xFFFD;

struct FontFile {
  std::vector<unsigned char> bytes;
  stbtt_fontinfo info{};
  bool good = false;

  void Read(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
    good = !bytes.empty() &&
           stbtt_InitFont(&info, bytes.data(), stbtt_GetFontOffsetForIndex(bytes.data(), 0));
  }
};

// Length of the character that begins with that byte; 0: none begins with it.
std::size_t LengthOf(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

Point Mix(Point a, Point b, float t) { return a + (b - a) * t; }

void AddStep(const stbtt_vertex& v, Point from, Point origin, float scale,
             std::vector<GlyphStep>& steps) {
  const auto place = [&](float x, float y) { return origin + Point{x * scale, -y * scale}; };
  const Point to = place(v.x, v.y);
  if (v.type == STBTT_vmove || v.type == STBTT_vline) {
    const auto kind = v.type == STBTT_vmove ? GlyphStep::Kind::kMove : GlyphStep::Kind::kLine;
    steps.push_back({kind, {}, {}, to});
  } else if (v.type == STBTT_vcurve) {  // a quadratic curve as a cubic one
    const Point bend = place(v.cx, v.cy);
    steps.push_back(
        {GlyphStep::Kind::kCurve, Mix(from, bend, 2.0F / 3), Mix(to, bend, 2.0F / 3), to});
  } else {
    steps.push_back({GlyphStep::Kind::kCurve, place(v.cx, v.cy), place(v.cx1, v.cy1), to});
  }
}

}  // namespace

struct Glyphs::Files {
  std::array<FontFile, 3> faces;
  FontFile icons;
  FontFile east_asian;
  float east_asian_size = 1;

  const FontFile& Of(std::uint32_t code, Face face) const {
    if (IsIcon(code)) return icons;
    const bool is_known = code < 0x10000;
    if (is_known && IsEastAsian(static_cast<ImWchar>(code))) return east_asian;
    return faces[static_cast<std::size_t>(face)];
  }
  // The fonts other than DejaVu are as high as one of its lines, as in editor/theme/fonts.h.
  float Scale(const FontFile& font, float em) const {
    constexpr float kEmOfLine = 0.859F;
    if (&font == &icons) return stbtt_ScaleForPixelHeight(&font.info, em / kEmOfLine);
    if (&font != &east_asian) return stbtt_ScaleForMappingEmToPixels(&font.info, em);
    return stbtt_ScaleForPixelHeight(&font.info, em / kEmOfLine * east_asian_size);
  }
};

Glyphs::Glyphs() : files_(std::make_unique<Files>()) {
  files_->faces[static_cast<std::size_t>(Face::kSans)].Read(TextFontFile("DejaVuSans.ttf"));
  files_->faces[static_cast<std::size_t>(Face::kBold)].Read(TextFontFile("DejaVuSans-Bold.ttf"));
  files_->faces[static_cast<std::size_t>(Face::kMono)].Read(TextFontFile("DejaVuSansMono.ttf"));
  files_->icons.Read(IconFontFile());
  const EastAsianFont east_asian = FindEastAsianFont();
  files_->east_asian.Read(east_asian.file);
  files_->east_asian_size = east_asian.size;
}

Glyphs::~Glyphs() = default;

std::vector<GlyphStep> Glyphs::OutlineOf(std::string_view utf8, Face face, float em, Point at,
                                         float width) const {
  std::vector<GlyphStep> steps;
  const std::vector<std::uint32_t> codes = CodePoints(utf8);
  const float left = at.x;
  for (const std::uint32_t code : codes) {
    const FontFile& font = files_->Of(code, face);
    if (!font.good) continue;
    const float scale = files_->Scale(font, em);
    stbtt_vertex* vertices = nullptr;
    const int count = stbtt_GetCodepointShape(&font.info, static_cast<int>(code), &vertices);
    Point from = at;
    for (int i = 0; i < count; ++i) {
      AddStep(vertices[i], from, at, scale, steps);
      from = steps.back().to;
    }
    stbtt_FreeShape(&font.info, vertices);
    int advance = 0;
    int bearing = 0;
    stbtt_GetCodepointHMetrics(&font.info, static_cast<int>(code), &advance, &bearing);
    at.x += static_cast<float>(advance) * scale;
  }
  const float natural = at.x - left;
  const float stretch = natural > 0 && width > 0 ? width / natural : 1;
  for (GlyphStep& step : steps) {
    for (Point* point : {&step.b, &step.c, &step.to}) point->x = left + (point->x - left) * stretch;
  }
  return steps;
}

std::vector<std::uint32_t> CodePoints(std::string_view utf8) {
  std::vector<std::uint32_t> codes;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i]);
    const std::size_t length = LengthOf(first);
    std::uint32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
    bool good = length > 0 && i + length <= utf8.size();
    for (std::size_t k = 1; good && k < length; ++k) {
      const auto next = static_cast<unsigned char>(utf8[i + k]);
      good = (next & 0xC0U) == 0x80U;
      code = (code << 6) | (next & 0x3FU);
    }
    codes.push_back(good ? code : kNoCharacter);
    i += good ? length : 1;
  }
  return codes;
}

}  // namespace coppice::editor
