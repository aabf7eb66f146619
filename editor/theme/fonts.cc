#include "editor/theme/fonts.h"

#ifdef COPPICE_HAS_FREETYPE
#include <imgui_freetype.h>
#endif

// After imgui.h, which it needs.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "bt_core/base/read_file.h"
#include "editor/theme/font_files.h"
#include "editor/theme/imgui_context.h"

namespace coppice::editor {
namespace {

constexpr float kSizes[] = {7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 19, 22, 25, 29, 34, 40};

constexpr ImWchar kNowhere = 0x25AF;    // a narrow box: for what no font has
constexpr float kMostEastAsian = 2000;  // at scale 1: then the texture has 8000 rows
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

// The usual characters, and those of these that DejaVu may have, as ranges.
std::vector<ImWchar> TextRanges(const CharacterSet& more) {
  std::vector<ImWchar> ranges;
  for (const ImWchar* at = UsualCharacters(); *at != 0; ++at) ranges.push_back(*at);
  for (const ImWchar code : more) {
    if (!IsEastAsian(code)) ranges.insert(ranges.end(), {code, code});
  }
  ranges.push_back(0);
  return ranges;
}

// Those of East Asia, but no more than there is room for; ends with 0.
std::vector<ImWchar> EastAsianRanges(const CharacterSet& more, float scale) {
  const auto room = static_cast<std::size_t>(kMostEastAsian / (scale * scale));
  std::vector<ImWchar> ranges;
  for (const ImWchar code : more) {
    if (IsEastAsian(code) && ranges.size() < 2 * room) ranges.insert(ranges.end(), {code, code});
  }
  ranges.push_back(0);
  return ranges;
}

}  // namespace

Fonts::Fonts(float scale, CharacterSet more)
    : scale_(scale), more_(std::move(more)), atlas_(std::make_unique<ImFontAtlas>()) {
  error_ = Load();
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

std::string Fonts::Load() {
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
  const std::vector<ImWchar> ranges = TextRanges(more_);
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
  const bool has_east_asian = AddEastAsian();
  if (!atlas.Build()) return "the fonts cannot be baked into a texture";
  if (has_east_asian) ShareEastAsian();
  MarkMissing();
  usual_ = Pick(Face::kSans, 13 * scale_);
  return {};
}

// Merged into the plain face alone. False if there are none, or no font for them.
bool Fonts::AddEastAsian() {
  east_asian_ = EastAsianRanges(more_, scale_);
  const EastAsianFont font = FindEastAsianFont();
  if (east_asian_.size() == 1 || !Read(font.file, files_.east_asian)) return false;
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    ImFontConfig config;
    config.MergeMode = true;
    config.DstFont = sans_[i];
    config.OversampleH = 1;
    config.OversampleV = 1;
#ifdef COPPICE_HAS_FREETYPE
    config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_NoHinting;  // it takes most of the time
#endif
    AddFont(files_.east_asian, std::round(sizes_[i] * font.size), config, east_asian_.data(),
            *atlas_);
  }
  return true;
}

// The other faces show the same pixels: there is no bold one, and each would need a texture as
// large.
void Fonts::ShareEastAsian() {
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    for (ImFont* const font : {bold_[i], mono_[i]}) {
      for (std::size_t k = 0; k + 1 < east_asian_.size(); k += 2) {
        const ImFontGlyph* const glyph = sans_[i]->FindGlyphNoFallback(east_asian_[k]);
        if (!glyph) continue;
        font->AddGlyph(nullptr, east_asian_[k], glyph->X0, glyph->Y0, glyph->X1, glyph->Y1,
                       glyph->U0, glyph->V0, glyph->U1, glyph->V1, glyph->AdvanceX);
      }
      font->BuildLookupTable();
    }
  }
}

// Instead of the question mark, which texts have too.
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
  }
}

void Fonts::Note(std::string_view text) const {
  for (const ImWchar code : UnusualCharacters(text)) {
    if (more_.count(code) == 0) lacking_.insert(code);
  }
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
