// What is written on the screen, found in what Dear ImGui draws: every glyph with its colour and
// what is behind it. So rules on text hold for everything, whoever drew it.
#ifndef COPPICE_TESTS_EDITOR_GALLERY_DRAWN_TEXT_H_
#define COPPICE_TESTS_EDITOR_GALLERY_DRAWN_TEXT_H_

#include <cstdint>
#include <string>
#include <vector>

#include "editor/shell/editor.h"

namespace coppice::editor {

struct DrawnGlyph {
  std::uint32_t code;  ///< Unicode
  Box box;
  Box clip;          ///< what is outside of it is not seen
  Color color;       ///< with alpha
  Color background;  ///< of most of its box, if that is asked for
  int text;          ///< glyphs that follow each other in a line have the same

  bool is_icon() const { return code >= 0xE000; }
};

/// Those of the last frame that are seen: not clipped away, and nothing opaque lies over them.
std::vector<DrawnGlyph> DrawnText(const Editor& editor);
/// The same with their backgrounds, for which all is painted once more.
std::vector<DrawnGlyph> DrawnTextOnBackground(const Editor& editor);

/// Each as a line for people: the text, where it is, and the figure. Empty: all is well.
std::vector<std::string> FaintTexts(const std::vector<DrawnGlyph>& glyphs);
/// Cut off at the side rather than ended with an ellipsis; not within the boxes of `scrolled`.
std::vector<std::string> CutTexts(const std::vector<DrawnGlyph>& glyphs,
                                  const std::vector<Box>& scrolled);
/// Begin in one of the boxes and end on the right of it.
std::vector<std::string> StrayTexts(const std::vector<DrawnGlyph>& glyphs,
                                    const std::vector<Box>& boxes);
/// Written over each other.
std::vector<std::string> OverlappingTexts(const std::vector<DrawnGlyph>& glyphs);

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_GALLERY_DRAWN_TEXT_H_
