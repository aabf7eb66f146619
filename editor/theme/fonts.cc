#include "editor/theme/fonts.h"

#ifdef COPPICE_HAS_FREETYPE
#include <imgui_freetype.h>
#endif

// After imgui.h, which it needs.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "bt_core/base/read_file.h"
#include "editor/theme/font_files.h"
#include "editor/theme/imgui_context.h"

namespace coppice::editor {
namespace {

constexpr float kSizes[] = {7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 19, 22, 25, 29, 34, 40};

constexpr ImWchar kTextRanges[] = {0x0020, 0x017F, 0x0391, 0x03C9, 0x2010, 0x2026, 0x203A, 0x203A,
                                   0x2190, 0x2193, 0x21C9, 0x21C9, 0x2248, 0x2248, 0x2260, 0x2265,
                                   0x25A0, 0x25A1, 0x25AF, 0x25AF, 0x25B2, 0x25CF, 0};
// · × – … › → ⇉, kMissing and kNowhere.
constexpr ImWchar kUsualRanges[] = {0x0020, 0x007E, 0x00B7, 0x00B7, 0x00D7, 0x00D7, 0x2013,
                                    0x2013, 0x2026, 0x2026, 0x203A, 0x203A, 0x2192, 0x2192,
                                    0x21C9, 0x21C9, 0x25A1, 0x25A1, 0x25AF, 0x25AF, 0};
constexpr ImWchar kMissing = 0x25A1;  // a square: for what could have been baked
constexpr ImWchar kNowhere = 0x25AF;  // a narrow box: for what no font has
constexpr ImWchar kIconRanges[] = {
    0xF002, 0xF002, 0xF00C, 0xF00D, 0xF017, 0xF017, 0xF01E, 0xF01E, 0xF021, 0xF021, 0xF048,
    0xF048, 0xF04B, 0xF04E, 0xF051, 0xF051, 0xF059, 0xF059, 0xF06A, 0xF06A, 0xF071, 0xF071,
    0xF07B, 0xF07C, 0xF085, 0xF085, 0xF08D, 0xF08D, 0xF0D7, 0xF0D7, 0xF0E7, 0xF0E8, 0xF0FE,
    0xF0FE, 0xF10C, 0xF10C, 0xF111, 0xF111, 0xF121, 0xF121, 0xF126, 0xF126, 0xF132, 0xF132,
    0xF146, 0xF146, 0xF1C9, 0xF1C9, 0xF1E6, 0xF1E6, 0xF252, 0xF252, 0};

// The atlas would copy the file once for each size.
ImFont* AddFont(std::string& file, float pixels, const ImFontConfig& config, const ImWchar* ranges,
                ImFontAtlas& atlas) {
  ImFont* const font = atlas.AddFontFromMemoryTTF(file.data(), static_cast<int>(file.size()),
                                                  pixels, &config, ranges);
  atlas.ConfigData.back().FontDataOwnedByAtlas = false;
  return font;
}

void Bake(std::string& text_file, std::string* icon_file, const std::vector<float>& sizes,
          const ImWchar* ranges, ImFontAtlas& atlas, std::vector<ImFont*>& fonts) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const float pixels = sizes[i];
    ImFontConfig config;
    config.OversampleH = kSizes[i] < 16 ? 2 : 1;
    config.OversampleV = 1;
    fonts.push_back(AddFont(text_file, pixels, config, ranges, atlas));
    if (!icon_file) continue;
    config.MergeMode = true;
    config.GlyphMinAdvanceX = pixels;
    config.GlyphOffset.y = 0;
    AddFont(*icon_file, pixels, config, kIconRanges, atlas);
  }
}

bool Read(const std::string& path, std::string& bytes) {
  auto read = ReadFile(path);
  if (read) bytes = *std::move(read);
  return !bytes.empty();
}

bool IsIn(const ImWchar* ranges, unsigned code) {
  for (; *ranges != 0; ranges += 2) {
    if (code >= ranges[0] && code <= ranges[1]) return true;
  }
  return false;
}

// These ranges and the characters of a text, as ranges.
std::vector<ImWchar> RangesOf(const ImWchar* ranges, const std::vector<ImWchar>& more) {
  std::vector<ImWchar> all;
  for (; *ranges != 0; ++ranges) all.push_back(*ranges);
  for (const ImWchar code : more) all.insert(all.end(), {code, code});
  all.push_back(0);
  return all;
}

}  // namespace

std::vector<ImWchar> UnusualCharacters(std::string_view text) {
  const auto is_plain = [](char byte) { return static_cast<unsigned char>(byte) < 0x80; };
  std::set<ImWchar> found;
  auto at = std::find_if_not(text.begin(), text.end(), is_plain);
  while (at != text.end()) {
    unsigned code = 0;
    at += ImTextCharFromUtf8(&code, &*at, text.data() + text.size());
    if (!IsIn(kUsualRanges, code) && IsIn(kTextRanges, code)) {
      found.insert(static_cast<ImWchar>(code));
    }
    at = std::find_if_not(at, text.end(), is_plain);
  }
  return {found.begin(), found.end()};
}

Fonts::Fonts(float scale, Characters characters, const std::vector<ImWchar>& more)
    : scale_(scale), characters_(characters), atlas_(std::make_unique<ImFontAtlas>()) {
  error_ = Load(more);
}

ImGuiContext* Fonts::MakeContext() const {
  const WithContext unchanged(ImGui::GetCurrentContext());
  ImGuiContext* const context = ImGui::CreateContext(atlas_.get());
  ImGui::SetCurrentContext(context);
  UseInContext();
  return context;
}

void Fonts::UseInContext() const {
  atlas_->SetTexID(nullptr);
  ImGui::GetIO().Fonts = atlas_.get();
  ImGui::GetIO().FontDefault = usual_;
}

std::string Fonts::Load(const std::vector<ImWchar>& more) {
  ImFontAtlas& atlas = *atlas_;
#ifdef COPPICE_HAS_FREETYPE
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
#endif
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.TexDesiredWidth = 2048;
  const std::string icons = IconFontFile();
  if (icons.empty()) {
    return "the font fontawesome-webfont.ttf is missing; on Debian: apt-get install "
           "fonts-font-awesome";
  }
  if (!Read(icons, files_.icons)) return "the font " + icons + " cannot be read";
  const struct {
    const char* file;
    std::string& text;
    std::vector<ImFont*>& fonts;
    bool with_icons;
  } kFaces[] = {{"DejaVuSans.ttf", files_.sans, sans_, true},
                {"DejaVuSans-Bold.ttf", files_.bold, bold_, true},
                {"DejaVuSansMono.ttf", files_.mono, mono_, false}};
  const std::vector<ImWchar> ranges =
      RangesOf(characters_ == Characters::kAll ? kTextRanges : kUsualRanges, more);
  for (const float size : kSizes) sizes_.push_back(std::round(size * scale_));
  for (const auto& face : kFaces) {
    const std::string file = TextFontFile(face.file);
    if (file.empty()) {
      return std::string("the font ") + face.file +
             " is missing; on Debian: apt-get install fonts-dejavu-core";
    }
    if (!Read(file, face.text)) return "the font " + file + " cannot be read";
    Bake(face.text, face.with_icons ? &files_.icons : nullptr, sizes_, ranges.data(), atlas,
         face.fonts);
  }
  if (!atlas.Build()) return "the fonts cannot be baked into a texture";
  MarkMissing();
  usual_ = Pick(Face::kSans, 13 * scale_);
  return {};
}

// Instead of the question mark, which texts have too. Characters that are not baked here, but could
// be, look otherwise than those that no font has: only for the first is it worth baking again.
void Fonts::MarkMissing() {
  constexpr auto kNone = static_cast<ImWchar>(-1);
  for (ImFont* const font : atlas_->Fonts) {
    const ImFontGlyph* const box = font->FindGlyphNoFallback(kNowhere);
    if (!box) continue;
    font->FallbackGlyph = box;
    font->FallbackAdvanceX = box->AdvanceX;
    for (int code = 0; code < font->IndexLookup.Size; ++code) {
      if (font->IndexLookup[code] == kNone) font->IndexAdvanceX[code] = box->AdvanceX;
    }
    if (characters_ == Characters::kAll) continue;
    for (const ImWchar* range = kTextRanges; *range != 0; range += 2) {
      for (ImWchar code = range[0]; code <= range[1]; ++code) {
        if (!font->FindGlyphNoFallback(code)) font->AddRemapChar(code, kMissing);
      }
    }
  }
}

bool Fonts::Lacks(const ImDrawData& drawn) const {
  if (characters_ == Characters::kAll) return false;
  std::set<std::pair<float, float>> boxes;  // where they begin in the texture
  for (const ImFont* const font : atlas_->Fonts) {
    const ImFontGlyph* const box = font->FindGlyph(kMissing);
    boxes.emplace(box->U0, box->V0);
  }
  for (int i = 0; i < drawn.CmdListsCount; ++i) {
    for (const ImDrawVert& corner : drawn.CmdLists[i]->VtxBuffer) {
      if (boxes.count({corner.uv.x, corner.uv.y}) > 0) return true;
    }
  }
  return false;
}

bool Fonts::Lacks(std::string_view text) const {
  if (characters_ == Characters::kAll) return false;
  const ImFont& font = *sans_.front();
  const std::vector<ImWchar> unusual = UnusualCharacters(text);
  return std::any_of(unusual.begin(), unusual.end(), [&](ImWchar code) {
    return font.FindGlyph(code) == font.FindGlyph(kMissing);
  });
}

ImFont* Fonts::Pick(Face face, float pixels) const {
  const std::vector<ImFont*>& fonts = face == Face::kSans   ? sans_
                                      : face == Face::kBold ? bold_
                                                            : mono_;
  const auto larger = std::upper_bound(sizes_.begin(), sizes_.end(), pixels + 0.01F);
  return fonts[larger == sizes_.begin() ? 0
                                        : static_cast<std::size_t>(larger - sizes_.begin()) - 1];
}

}  // namespace coppice::editor
