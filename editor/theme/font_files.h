// Where the font files lie on this computer.
#ifndef COPPICE_EDITOR_THEME_FONT_FILES_H_
#define COPPICE_EDITOR_THEME_FONT_FILES_H_

#include <string>

namespace coppice::editor {

/// The path of a file of DejaVu, such as "DejaVuSans.ttf"; empty if it is not installed.
std::string TextFontFile(const char* name);

/// The path of Font Awesome 4.7; empty if it is not installed.
std::string IconFontFile();

/// A font with the characters of East Asia, which DejaVu lacks.
struct EastAsianFont {
  std::string file;  ///< empty: none is installed
  float size = 1;    ///< this many times the height of DejaVu, it suits to it
};
EastAsianFont FindEastAsianFont();

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_FONT_FILES_H_
