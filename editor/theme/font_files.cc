#include "editor/theme/font_files.h"

#include <cstddef>
#include <filesystem>

namespace coppice::editor {
namespace {

// Debian and Ubuntu, Fedora, Arch.
constexpr const char* kTextFolders[] = {"/usr/share/fonts/truetype/dejavu/",
                                        "/usr/share/fonts/dejavu-sans-fonts/",
                                        "/usr/share/fonts/TTF/"};
constexpr const char* kIconFolders[] = {"/usr/share/fonts/truetype/font-awesome/",
                                        "/usr/share/fonts-font-awesome/fonts/",
                                        "/usr/share/fonts/TTF/"};

// Of Debian's fonts-wqy-microhei, which has all of Chinese, Japanese and Korean, fonts-noto-cjk,
// which is read four times as long, and fonts-droid-fallback, which has no Korean; and where Fedora
// and Arch have them. A tenth larger than letters: they have more strokes.
struct {
  const char* file;
  float size;
} constexpr kEastAsian[] = {
    {"/usr/share/fonts/truetype/wqy/wqy-microhei.ttc", 1.1F},
    {"/usr/share/fonts/wqy-microhei/wqy-microhei.ttc", 1.1F},
    {"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", 1.36F},
    {"/usr/share/fonts/google-noto-sans-cjk-fonts/NotoSansCJK-Regular.ttc", 1.36F},
    {"/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc", 1.36F},
    {"/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf", 1.23F}};

template <std::size_t kCount>
std::string FindFile(const char* const (&folders)[kCount], const char* name) {
  for (const char* folder : folders) {
    std::error_code error;
    if (std::filesystem::exists(std::string(folder) + name, error)) {
      return std::string(folder) + name;
    }
  }
  return {};
}

}  // namespace

std::string TextFontFile(const char* name) { return FindFile(kTextFolders, name); }

std::string IconFontFile() { return FindFile(kIconFolders, "fontawesome-webfont.ttf"); }

EastAsianFont FindEastAsianFont() {
  for (const auto& [file, size] : kEastAsian) {
    std::error_code error;
    if (std::filesystem::exists(file, error)) return {file, size};
  }
  return {};
}

}  // namespace coppice::editor
