// Pictures of tests and of programs without a display come from here, hundreds of them, and are
// compared bit by bit. So everything is whole numbers, no edge of two triangles is painted twice,
// and what Dear ImGui draws most, boxes and glyphs along the axes, has a short way of its own.
#include "editor/render/rasteriser.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace coppice::editor {
namespace {

constexpr int kSubpixels = 256;

struct Clip {
  int left, top, right, bottom;
};

std::uint32_t Channel(std::uint32_t color, int shift) { return (color >> shift) & 0xFFU; }

// `alpha` 0..255 on top of the colour's own.
void Blend(std::uint32_t& pixel, std::uint32_t color, std::uint32_t alpha) {
  const std::uint32_t a = (Channel(color, 24) * alpha + 127) / 255;
  if (a == 0) return;
  if (a == 255) {
    pixel = color | 0xFF000000U;
    return;
  }
  std::uint32_t mixed = 0xFF000000U;
  for (const int shift : {0, 8, 16}) {
    const std::uint32_t value = Channel(color, shift) * a + Channel(pixel, shift) * (255 - a);
    mixed |= ((value + 127) / 255) << shift;
  }
  pixel = mixed;
}

// As Blend with all of its own opacity, to each pixel: most of a picture is painted so.
void Fill(std::uint32_t* begin, std::uint32_t* end, std::uint32_t color) {
  if (Channel(color, 24) == 255) {
    std::fill(begin, end, color);
  } else {
    for (std::uint32_t* pixel = begin; pixel < end; ++pixel) Blend(*pixel, color, 255);
  }
}

std::uint32_t Sample(const Texture& texture, float u, float v) {
  const float x = u * static_cast<float>(texture.width) - 0.5F;
  const float y = v * static_cast<float>(texture.height) - 0.5F;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const auto fx = static_cast<std::uint32_t>((x - static_cast<float>(x0)) * 256.0F);
  const auto fy = static_cast<std::uint32_t>((y - static_cast<float>(y0)) * 256.0F);
  const auto texel = [&](int i, int j) -> std::uint32_t {
    i = std::clamp(i, 0, texture.width - 1);
    j = std::clamp(j, 0, texture.height - 1);
    return texture.alpha[static_cast<std::size_t>(j) * static_cast<std::size_t>(texture.width) +
                         static_cast<std::size_t>(i)];
  };
  const std::uint32_t top = texel(x0, y0) * (256 - fx) + texel(x0 + 1, y0) * fx;
  const std::uint32_t bottom = texel(x0, y0 + 1) * (256 - fx) + texel(x0 + 1, y0 + 1) * fx;
  return (top * (256 - fy) + bottom * fy + (1U << 15)) >> 16;
}

class Painter {
 public:
  Painter(const Texture& texture, Image& image) : texture_(texture), image_(image) {}

  void SetClip(const ImVec4& rect) {
    clip_ = {std::max(0, static_cast<int>(rect.x)), std::max(0, static_cast<int>(rect.y)),
             std::min(image_.width, static_cast<int>(rect.z)),
             std::min(image_.height, static_cast<int>(rect.w))};
  }

  // Glyphs and boxes come as two triangles; painting them as one box is several times faster.
  bool Box(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const ImDrawVert& d) {
    const bool upright = a.pos.y == b.pos.y && b.pos.x == c.pos.x && c.pos.y == d.pos.y &&
                         d.pos.x == a.pos.x && a.pos.x < c.pos.x && a.pos.y < c.pos.y;
    if (!upright || a.col != b.col || a.col != c.col || a.col != d.col) return false;
    if (IsUnseen(a.col)) return true;
    const int left = std::max(clip_.left, FirstCenter(a.pos.x));
    const int right = std::min(clip_.right, FirstCenter(c.pos.x));
    const int top = std::max(clip_.top, FirstCenter(a.pos.y));
    const int bottom = std::min(clip_.bottom, FirstCenter(c.pos.y));
    const bool plain = a.uv.x == c.uv.x && a.uv.y == c.uv.y;
    const float du = (c.uv.x - a.uv.x) / (c.pos.x - a.pos.x);
    const float dv = (c.uv.y - a.uv.y) / (c.pos.y - a.pos.y);
    for (int y = top; y < bottom; ++y) {
      std::uint32_t* row = Row(y);
      if (plain) {
        if (left < right) Fill(row + left, row + right, a.col);
        continue;
      }
      const float v = a.uv.y + (static_cast<float>(y) + 0.5F - a.pos.y) * dv;
      for (int x = left; x < right; ++x) {
        const float u = a.uv.x + (static_cast<float>(x) + 0.5F - a.pos.x) * du;
        Blend(row[x], a.col, Sample(texture_, u, v));
      }
    }
    return true;
  }

  void Triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c) {
    const Fixed p[3] = {ToFixed(a.pos), ToFixed(b.pos), ToFixed(c.pos)};
    const std::int64_t area = Cross(p[0], p[1], p[2]);
    if (area == 0) return;
    if (area < 0) {
      Triangle(a, c, b);
      return;
    }
    const int left = std::max<int>(clip_.left, Floor(std::min({p[0].x, p[1].x, p[2].x})));
    const int right = std::min<int>(clip_.right, Floor(std::max({p[0].x, p[1].x, p[2].x})) + 1);
    const int top = std::max<int>(clip_.top, Floor(std::min({p[0].y, p[1].y, p[2].y})));
    const int bottom = std::min<int>(clip_.bottom, Floor(std::max({p[0].y, p[1].y, p[2].y})) + 1);
    const Edge edges[3] = {MakeEdge(p[1], p[2]), MakeEdge(p[2], p[0]), MakeEdge(p[0], p[1])};
    const bool one_color = a.col == b.col && a.col == c.col;
    if (one_color && IsUnseen(a.col)) return;
    const bool plain = a.uv.x == b.uv.x && a.uv.x == c.uv.x && a.uv.y == b.uv.y && a.uv.y == c.uv.y;
    for (int y = top; y < bottom; ++y) {
      const Span span = Inside(edges, left, right, y);
      if (span.begin >= span.end) continue;
      if (one_color && plain) {
        Fill(Row(y) + span.begin, Row(y) + span.end, a.col);
        continue;
      }
      std::int64_t e[2] = {At(edges[1], span.begin, y), At(edges[2], span.begin, y)};
      for (int x = span.begin; x < span.end; ++x) {
        const float wb = static_cast<float>(e[0]) / static_cast<float>(area);
        const float wc = static_cast<float>(e[1]) / static_cast<float>(area);
        const std::uint32_t color = one_color ? a.col : MixColors(a.col, b.col, c.col, wb, wc);
        const float u = a.uv.x + (b.uv.x - a.uv.x) * wb + (c.uv.x - a.uv.x) * wc;
        const float v = a.uv.y + (b.uv.y - a.uv.y) * wb + (c.uv.y - a.uv.y) * wc;
        Blend(Row(y)[x], color, plain ? 255 : Sample(texture_, u, v));
        e[0] += edges[1].step_x;
        e[1] += edges[2].step_x;
      }
    }
  }

 private:
  struct Fixed {
    std::int64_t x, y;
  };
  struct Edge {
    Fixed from;
    std::int64_t dx, dy, bias, step_x;
  };

  static bool IsUnseen(std::uint32_t color) { return Channel(color, 24) == 0; }
  static Fixed ToFixed(const ImVec2& p) {
    return {std::llround(p.x * kSubpixels), std::llround(p.y * kSubpixels)};
  }
  static std::int64_t Cross(const Fixed& a, const Fixed& b, const Fixed& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  static int Floor(std::int64_t value) { return static_cast<int>(value >> 8); }
  // The first pixel whose center is not left of (above) x.
  static int FirstCenter(float x) { return static_cast<int>(std::ceil(x - 0.5F)); }

  // A pixel on a left or top edge belongs to the triangle, on another edge it does not.
  static Edge MakeEdge(const Fixed& from, const Fixed& to) {
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = to.y - from.y;
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    return {from, dx, dy, top_left ? 0 : -1, -dy * kSubpixels};
  }
  static std::int64_t At(const Edge& edge, int x, int y) {
    const std::int64_t px = static_cast<std::int64_t>(x) * kSubpixels + kSubpixels / 2;
    const std::int64_t py = static_cast<std::int64_t>(y) * kSubpixels + kSubpixels / 2;
    return edge.dx * (py - edge.from.y) - edge.dy * (px - edge.from.x) + edge.bias;
  }

  // The pixels of a row between left and right that lie on the right side of all edges.
  struct Span {
    int begin, end;
  };
  static Span Inside(const Edge (&edges)[3], int left, int right, int y) {
    std::int64_t begin = 0;
    std::int64_t end = right - left;
    for (const Edge& edge : edges) {
      const std::int64_t first = At(edge, left, y);
      const std::int64_t step = edge.step_x;
      if (step > 0 && first < 0) begin = std::max(begin, (-first + step - 1) / step);
      if (step < 0 && first >= 0) end = std::min(end, first / -step + 1);
      if (step <= 0 && first < 0) end = 0;
    }
    return {left + static_cast<int>(std::min(begin, end)), left + static_cast<int>(end)};
  }

  static std::uint32_t MixColors(std::uint32_t a, std::uint32_t b, std::uint32_t c, float wb,
                                 float wc) {
    std::uint32_t mixed = 0;
    for (const int shift : {0, 8, 16, 24}) {
      const float value = static_cast<float>(Channel(a, shift)) * (1 - wb - wc) +
                          static_cast<float>(Channel(b, shift)) * wb +
                          static_cast<float>(Channel(c, shift)) * wc;
      mixed |= static_cast<std::uint32_t>(std::clamp(value + 0.5F, 0.0F, 255.0F)) << shift;
    }
    return mixed;
  }

  std::uint32_t* Row(int y) {
    return image_.pixels.data() +
           static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width);
  }

  const Texture& texture_;
  Image& image_;
  Clip clip_{};
};

void PaintCommand(const ImDrawList& list, const ImDrawCmd& command, Painter& painter) {
  const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
    const ImDrawIdx* t = index + i;
    const bool maybe_box = i + 5 < command.ElemCount && t[3] == t[0] && t[4] == t[2];
    if (maybe_box && painter.Box(vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[5]])) {
      i += 3;
      continue;
    }
    painter.Triangle(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
}

}  // namespace

void Rasterise(const ImDrawData& data, const Texture& texture, Image& image) {
  Painter painter(texture, image);
  for (int n = 0; n < data.CmdListsCount; ++n) {
    const ImDrawList& list = *data.CmdLists[n];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback) continue;
      painter.SetClip(
          {command.ClipRect.x - data.DisplayPos.x, command.ClipRect.y - data.DisplayPos.y,
           command.ClipRect.z - data.DisplayPos.x, command.ClipRect.w - data.DisplayPos.y});
      PaintCommand(list, command, painter);
    }
  }
}

}  // namespace coppice::editor
