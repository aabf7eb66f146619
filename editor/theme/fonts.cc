#include "editor/theme/fonts.h"

#ifdef COPPICE_HAS_FREETYPE
#include <imgui_freetype.h>
#endif

#include <algorithm>
#include <cmath>
#include <iterator>

#include "editor/theme/font_files.h"
#include "editor/theme/imgui_context.h"

namespace coppice::editor {
namespace {

constexpr float kSizes[] = {7, 8, 9, 10, 11, 12, 13, 14, 15, 17, 19, 22, 25, 29, 34, 40};

constexpr ImWchar kTextRanges[] = {0x0020, 0x017F, 0x0391, 0x03C9, 0x2010, 0x2026, 0x203A,
                                   0x203A, 0x2190, 0x2193, 0x21C9, 0x21C9, 0x2248, 0x2248,
                                   0x2260, 0x2265, 0x25A0, 0x25A1, 0x25B2, 0x25CF, 0};
constexpr ImWchar kIconRanges[] = {
    0xF002, 0xF002, 0xF00C, 0xF00D, 0xF017, 0xF017, 0xF01E, 0xF01E, 0xF021, 0xF021, 0xF048,
    0xF048, 0xF04B, 0xF04E, 0xF051, 0xF051, 0xF059, 0xF059, 0xF06A, 0xF06A, 0xF071, 0xF071,
    0xF07B, 0xF07C, 0xF085, 0xF085, 0xF08D, 0xF08D, 0xF0D7, 0xF0D7, 0xF0E7, 0xF0E8, 0xF0FE,
    0xF0FE, 0xF10C, 0xF10C, 0xF111, 0xF111, 0xF121, 0xF121, 0xF126, 0xF126, 0xF132, 0xF132,
    0xF146, 0xF146, 0xF1C9, 0xF1C9, 0xF1E6, 0xF1E6, 0xF252, 0xF252, 0};

void Bake(const std::string& text_file, const std::string& icon_file,
          const std::vector<float>& sizes, ImFontAtlas& atlas, std::vector<ImFont*>& fonts) {
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const float pixels = sizes[i];
    ImFontConfig config;
    config.OversampleH = kSizes[i] < 16 ? 2 : 1;
    config.OversampleV = 1;
    fonts.push_back(atlas.AddFontFromFileTTF(text_file.c_str(), pixels, &config, kTextRanges));
    if (icon_file.empty()) continue;
    config.MergeMode = true;
    config.GlyphMinAdvanceX = pixels;
    config.GlyphOffset.y = 0;
    atlas.AddFontFromFileTTF(icon_file.c_str(), pixels, &config, kIconRanges);
  }
}

}  // namespace

Fonts::Fonts(float scale) : scale_(scale), atlas_(std::make_unique<ImFontAtlas>()) {
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
  const struct {
    const char* file;
    std::vector<ImFont*>& fonts;
    bool with_icons;
  } kFaces[] = {{"DejaVuSans.ttf", sans_, true},
                {"DejaVuSans-Bold.ttf", bold_, true},
                {"DejaVuSansMono.ttf", mono_, false}};
  for (const float size : kSizes) sizes_.push_back(std::round(size * scale_));
  for (const auto& face : kFaces) {
    const std::string file = TextFontFile(face.file);
    if (file.empty()) {
      return std::string("the font ") + face.file +
             " is missing; on Debian: apt-get install fonts-dejavu-core";
    }
    Bake(file, face.with_icons ? icons : std::string(), sizes_, atlas, face.fonts);
  }
  if (!atlas.Build()) return "the fonts cannot be baked into a texture";
  usual_ = Pick(Face::kSans, 13 * scale_);
  return {};
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
