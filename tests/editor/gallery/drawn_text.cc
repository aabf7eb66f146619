#include "tests/editor/gallery/drawn_text.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "editor/render/rasteriser.h"
#include "editor/theme/contrast.h"
#include "editor/theme/imgui_context.h"

namespace coppice::editor {
namespace {

constexpr Color kOpaque = 0xFF000000;

// A place in the texture of the fonts.
std::uint64_t CornerOf(float u, float v) {
  std::uint32_t bits[2];
  std::memcpy(&bits[0], &u, sizeof(u));
  std::memcpy(&bits[1], &v, sizeof(v));
  return std::uint64_t{bits[0]} << 32 | bits[1];
}

// Where each glyph lies there.
std::unordered_map<std::uint64_t, std::uint32_t> GlyphsOfFonts() {
  std::unordered_map<std::uint64_t, std::uint32_t> codes;
  for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) {
    codes.reserve(codes.size() + static_cast<std::size_t>(font->Glyphs.Size));
    for (const ImFontGlyph& glyph : font->Glyphs) {
      if (glyph.Visible) codes[CornerOf(glyph.U0, glyph.V0)] = glyph.Codepoint;
    }
  }
  return codes;
}

// A copy of what is drawn, with colours of its own.
class Copy {
 public:
  explicit Copy(const ImDrawData& data) : data_(data) {
    for (int i = 0; i < data.CmdListsCount; ++i) {
      lists_.emplace_back(data.CmdLists[i]->CloneOutput());
      pointers_.push_back(lists_.back().get());
    }
    data_.CmdLists = pointers_.data();
  }

  ImDrawList& list(int i) { return *pointers_[static_cast<std::size_t>(i)]; }

  Image Paint() const {
    const ImGuiIO& io = ImGui::GetIO();
    Texture texture;
    unsigned char* alpha = nullptr;
    io.Fonts->GetTexDataAsAlpha8(&alpha, &texture.width, &texture.height);
    texture.alpha = alpha;
    Image image =
        MakeImage(static_cast<int>(io.DisplaySize.x), static_cast<int>(io.DisplaySize.y), kOpaque);
    Rasterise(data_, texture, image);
    return image;
  }

 private:
  struct Free {
    void operator()(ImDrawList* list) const { IM_DELETE(list); }
  };
  ImDrawData data_;
  std::vector<std::unique_ptr<ImDrawList, Free>> lists_;
  std::vector<ImDrawList*> pointers_;
};

// The colour that most of the box has: a line that passes behind a letter does not count.
Color MostOf(const Image& image, const Box& box) {
  std::map<Color, int> counts;
  const auto begin_x = std::max(0, static_cast<int>(box.min.x));
  const auto begin_y = std::max(0, static_cast<int>(box.min.y));
  for (int y = begin_y; y < std::min<int>(image.height, static_cast<int>(box.max.y) + 1); ++y) {
    for (int x = begin_x; x < std::min<int>(image.width, static_cast<int>(box.max.x) + 1); ++x) {
      ++counts[image.At(x, y)];
    }
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? kOpaque : most->first;
}

struct Found {
  DrawnGlyph glyph;
  std::uint32_t order;
};

class Finder {
 public:
  explicit Finder(const ImDrawData& data)
      : codes_(GlyphsOfFonts()), bare_(data), orders_(data), data_(data) {}

  std::vector<DrawnGlyph> Find() {
    for (int i = 0; i < data_.CmdListsCount; ++i) {
      for (const ImDrawCmd& command : data_.CmdLists[i]->CmdBuffer) Read(i, command);
    }
    const Image order = orders_.Paint();
    std::vector<DrawnGlyph> seen;
    for (const Found& found : found_) {
      if (IsSeen(found, order)) seen.push_back(found.glyph);
    }
    return seen;
  }

  // What is behind each.
  void AddBackgrounds(std::vector<DrawnGlyph>& glyphs) const {
    const Image background = bare_.Paint();
    for (DrawnGlyph& glyph : glyphs) {
      const Box& clip = glyph.clip;
      const Box& box = glyph.box;
      glyph.background =
          MostOf(background, {{std::max(box.min.x, clip.min.x), std::max(box.min.y, clip.min.y)},
                              {std::min(box.max.x, clip.max.x), std::min(box.max.y, clip.max.y)}});
    }
  }

 private:
  // Its middle, and not just half of it above or below the edge of what covers it.
  static bool IsSeen(const Found& found, const Image& order) {
    const Point at = found.glyph.box.center();
    const int x = static_cast<int>(at.x);
    const int y = static_cast<int>(at.y);
    const auto is_covered = [&](int row) { return (order.At(x, row) & ~kOpaque) > found.order; };
    return found.glyph.clip.Contains(at) && x >= 0 && y >= 1 && x < order.width &&
           y + 1 < order.height && !is_covered(y - 1) && !is_covered(y) && !is_covered(y + 1);
  }

  // Everything else gets the colour that says when it is drawn; glyphs are left out. Triangles
  // between the same corners are one shape, drawn at one time: the corners of a shape follow each
  // other.
  void Read(int list, const ImDrawCmd& command) {
    const ImDrawList& drawn = *data_.CmdLists[list];
    ImDrawVert* const bare = bare_.list(list).VtxBuffer.Data + command.VtxOffset;
    ImDrawVert* const orders = orders_.list(list).VtxBuffer.Data + command.VtxOffset;
    const ImDrawVert* const vertices = drawn.VtxBuffer.Data + command.VtxOffset;
    const ImDrawIdx* const index = drawn.IdxBuffer.Data + command.IdxOffset;
    int first_corner = 0;
    int last_corner = -1;
    for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
      const ImDrawVert& first = vertices[index[i]];
      const auto code = codes_.find(CornerOf(first.uv.x, first.uv.y));
      const bool is_quad = i + 5 < command.ElemCount && index[i + 3] == index[i];
      const auto [low, high] = std::minmax<int>({index[i], index[i + 1], index[i + 2]});
      const bool is_same_shape = low <= last_corner && high >= first_corner;
      if (!is_same_shape) ++order_;
      first_corner = is_same_shape ? std::min(first_corner, low) : low;
      last_corner = is_same_shape ? std::max(last_corner, high) : high;
      if (code != codes_.end() && is_quad) {
        AddGlyph(code->second, first, vertices[index[i + 2]], command.ClipRect);
        for (unsigned k = 0; k < 6; ++k) bare[index[i + k]].col = orders[index[i + k]].col = 0;
        i += 3;
        continue;
      }
      for (unsigned k = 0; k < 3; ++k) {
        const bool opaque = (vertices[index[i + k]].col & kOpaque) == kOpaque;
        orders[index[i + k]].col = opaque ? kOpaque | order_ : 0;
      }
    }
  }

  void AddGlyph(std::uint32_t code, const ImDrawVert& first, const ImDrawVert& third,
                const ImVec4& clip) {
    const Box box = {{first.pos.x, first.pos.y}, {third.pos.x, third.pos.y}};
    const bool goes_on = !found_.empty() && found_.back().order + 1 == order_ &&
                         found_.back().glyph.color == first.col &&
                         std::abs(found_.back().glyph.box.max.y - box.max.y) < box.height() &&
                         box.min.x >= found_.back().glyph.box.min.x &&
                         box.min.x < found_.back().glyph.box.max.x + 2 * box.height();
    if (!goes_on) ++text_;
    found_.push_back(
        {{code, box, {{clip.x, clip.y}, {clip.z, clip.w}}, first.col, 0, text_}, order_});
  }

  const std::unordered_map<std::uint64_t, std::uint32_t> codes_;
  Copy bare_;
  Copy orders_;
  const ImDrawData& data_;
  std::vector<Found> found_;
  std::uint32_t order_ = 0;
  int text_ = 0;
};

std::string ToUtf8(std::uint32_t code) {
  std::string text;
  const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0U | (code >> 6));
    add(0x80U | (code & 0x3FU));
  } else {
    add(0xE0U | (code >> 12));
    add(0x80U | ((code >> 6) & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
  return text;
}

// The text that the glyph belongs to, and where it is.
std::string Describe(const std::vector<DrawnGlyph>& glyphs, const DrawnGlyph& one) {
  std::string text;
  for (const DrawnGlyph& glyph : glyphs) {
    if (glyph.text == one.text) text += glyph.is_icon() ? "(icon)" : ToUtf8(glyph.code);
  }
  char place[48];
  std::snprintf(place, sizeof(place), " at %.0f, %.0f", static_cast<double>(one.box.min.x),
                static_cast<double>(one.box.min.y));
  return "\"" + text + "\"" + place;
}

// Less than half opaque says: this does not count now.
bool IsFaded(const DrawnGlyph& glyph) { return (glyph.color >> 24) < 128; }

// One line for each text.
class Report {
 public:
  explicit Report(const std::vector<DrawnGlyph>& glyphs) : glyphs_(glyphs) {}
  void Add(const DrawnGlyph& glyph, const std::string& what) {
    if (texts_.insert(glyph.text).second) lines_.push_back(Describe(glyphs_, glyph) + what);
  }
  std::vector<std::string> Take() { return std::move(lines_); }

 private:
  const std::vector<DrawnGlyph>& glyphs_;
  std::set<int> texts_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<DrawnGlyph> DrawnText(const Editor& editor) {
  const WithContext current(editor.context());
  const ImDrawData* data = ImGui::GetDrawData();
  return data ? Finder(*data).Find() : std::vector<DrawnGlyph>();
}

std::vector<DrawnGlyph> DrawnTextOnBackground(const Editor& editor) {
  const WithContext current(editor.context());
  const ImDrawData* data = ImGui::GetDrawData();
  if (!data) return {};
  Finder finder(*data);
  std::vector<DrawnGlyph> glyphs = finder.Find();
  finder.AddBackgrounds(glyphs);
  return glyphs;
}

std::vector<std::string> FaintTexts(const std::vector<DrawnGlyph>& glyphs) {
  Report report(glyphs);
  for (const DrawnGlyph& glyph : glyphs) {
    if (IsFaded(glyph)) continue;
    const float alpha = static_cast<float>(glyph.color >> 24) / 255;
    const Color seen = Mix(glyph.background | kOpaque, glyph.color | kOpaque, alpha);
    const double contrast = Contrast(seen, glyph.background);
    if (contrast >= (glyph.is_icon() ? kVisible : kReadable)) continue;
    char figure[48];
    std::snprintf(figure, sizeof(figure), ": contrast %.2f, #%06X on #%06X", contrast,
                  __builtin_bswap32(seen) >> 8, __builtin_bswap32(glyph.background) >> 8);
    report.Add(glyph, figure);
  }
  return report.Take();
}

std::vector<std::string> CutTexts(const std::vector<DrawnGlyph>& glyphs,
                                  const std::vector<Box>& scrolled) {
  Report report(glyphs);
  for (const DrawnGlyph& glyph : glyphs) {
    const bool may_be = std::any_of(scrolled.begin(), scrolled.end(), [&](const Box& box) {
      return box.Contains(glyph.box.center());
    });
    if (may_be) continue;
    if (glyph.box.max.x > glyph.clip.max.x + 1 || glyph.box.min.x < glyph.clip.min.x - 1) {
      report.Add(glyph, " is cut off");
    }
  }
  return report.Take();
}

std::vector<std::string> StrayTexts(const std::vector<DrawnGlyph>& glyphs,
                                    const std::vector<Box>& boxes) {
  Report report(glyphs);
  const Box* around = nullptr;  // of the first glyph of the text
  int text = -1;
  for (const DrawnGlyph& glyph : glyphs) {
    const Point center = glyph.box.center();
    if (glyph.text != text) {
      const auto found = std::find_if(boxes.begin(), boxes.end(),
                                      [&](const Box& box) { return box.Contains(center); });
      around = found == boxes.end() ? nullptr : &*found;
      text = glyph.text;
    }
    if (around && center.x > around->max.x) report.Add(glyph, " goes on beyond its box");
  }
  return report.Take();
}

std::vector<std::string> OverlappingTexts(const std::vector<DrawnGlyph>& glyphs) {
  constexpr float kTouch = 0.3F;  // of the smaller glyph
  Report report(glyphs);
  for (std::size_t i = 0; i < glyphs.size(); ++i) {
    for (std::size_t k = i + 1; k < glyphs.size(); ++k) {
      const DrawnGlyph& a = glyphs[i];
      const DrawnGlyph& b = glyphs[k];
      if (a.text == b.text || IsFaded(a) || IsFaded(b)) continue;
      const float width = std::min(a.box.max.x, b.box.max.x) - std::max(a.box.min.x, b.box.min.x);
      const float height = std::min(a.box.max.y, b.box.max.y) - std::max(a.box.min.y, b.box.min.y);
      if (width <= 0 || height <= 0) continue;
      const float least = std::min(a.box.width() * a.box.height(), b.box.width() * b.box.height());
      if (width * height > kTouch * least) report.Add(a, " overlaps " + Describe(glyphs, b));
    }
  }
  return report.Take();
}

}  // namespace coppice::editor
