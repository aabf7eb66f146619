// The outlines of glyphs, for pictures that must not depend on the fonts of who looks at them.
#ifndef COPPICE_EDITOR_EXPORT_GLYPHS_H_
#define COPPICE_EDITOR_EXPORT_GLYPHS_H_

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "editor/theme/fonts.h"
#include "editor/theme/geometry.h"

namespace coppice::editor {

/// One piece of an outline. y grows downwards, the base line is 0.
struct GlyphStep {
  enum class Kind : std::uint8_t { kMove, kLine, kCurve };
  Kind kind = Kind::kMove;
  Point b, c;  ///< of kCurve: its inner points
  Point to;
};

class Glyphs {
 public:
  /// Reads the font files; a glyph of a missing file has no outline.
  Glyphs();
  ~Glyphs();

  /// The outline of a text whose base line begins at `at`, with an em of that size. The text is
  /// stretched to the width.
  std::vector<GlyphStep> OutlineOf(std::string_view utf8, Face face, float em, Point at,
                                   float width) const;

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

/// The characters of a text; what is no UTF-8 becomes U+FFFD.
std::vector<std::uint32_t> CodePoints(std::string_view utf8);

/// True for a character of the icon font.
inline bool IsIcon(std::uint32_t code) { return code >= 0xF000 && code < 0xF300; }

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_GLYPHS_H_
