// The fonts of the editor, baked at a ladder of sizes so that text is crisp at every zoom.
//
// DejaVu Sans, Sans Bold and Sans Mono, with the icons of Font Awesome merged into the first two,
// and the characters of East Asia from the font that this computer has for them. Baking takes a
// tenth of a second, so editors of one process may share them, and nothing is baked but the
// characters of nearly every text and those that are asked for. The fonts note what was written
// with them and is not baked: then make others. What no font has is a narrow empty box.
//
//   const auto fonts = std::make_shared<const Fonts>(1, UnusualCharacters(text));
//   ImGuiContext* const context = fonts->MakeContext();
#ifndef COPPICE_EDITOR_THEME_FONTS_H_
#define COPPICE_EDITOR_THEME_FONTS_H_

#include <imgui.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/theme/characters.h"

namespace coppice::editor {

enum class Face { kSans, kBold, kMono };

class Fonts {
 public:
  /// Bakes them for a screen of that scale (1 is an ordinary one): the usual characters, and `more`
  /// as far as fonts have them. The fonts keep the largest texture that OpenGL surely has: of
  /// East Asian characters 2000 at scale 1, 500 at scale 2; the others stay boxes.
  explicit Fonts(float scale, CharacterSet more = {});

  float scale() const { return scale_; }
  /// What they were asked to bake.
  const CharacterSet& more() const { return more_; }

  /// Characters that were written since the last call, and that they were not asked to bake.
  CharacterSet TakeLacking() const { return std::exchange(lacking_, {}); }

  /// Which file is missing, or empty. With an error, do not use them.
  const std::string& error() const { return error_; }

  /// A context of Dear ImGui that writes with these fonts; the current one stays what it is. The
  /// caller destroys it, before the fonts and on the thread of other contexts with these fonts.
  ImGuiContext* MakeContext() const;

  /// From its next frame on, the current context writes with these; between frames.
  void UseInContext() const;

  /// For writing that text: the largest baked font that is not larger than `pixels`; the smallest
  /// if all are larger. Notes what it lacks.
  ImFont* For(std::string_view text, Face face, float pixels) const {
    Note(text);
    return Pick(face, pixels);
  }
  /// The same without a text.
  ImFont* Pick(Face face, float pixels) const;

 private:
  std::string Load();
  bool AddEastAsian();
  void ShareEastAsian();
  void MarkMissing();
  void Note(std::string_view text) const;

  const float scale_;
  const CharacterSet more_;
  mutable CharacterSet lacking_;  // no part of what they are
  struct {
    std::string sans, bold, mono, icons, east_asian;
  } files_;                          // the atlas points into them
  std::vector<ImWchar> east_asian_;  // ranges; so does it into these
  std::unique_ptr<ImFontAtlas> atlas_;
  std::string error_;
  ImFont* usual_ = nullptr;
  std::vector<ImFont*> sans_, bold_, mono_;  // by rising size
  std::vector<float> sizes_;                 // theirs, in pixels
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_FONTS_H_
