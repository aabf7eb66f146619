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

}  // namespace coppice::editor
