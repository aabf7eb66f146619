// The fonts of the editor, baked at a ladder of sizes so that text is crisp at every zoom.
//
// DejaVu Sans, Sans Bold and Sans Mono, with the icons of Font Awesome merged into the first two.
// Baking takes a fifth of a second, so editors of one process may share them, and a window that
// comes up bakes first what its files need: the characters of nearly every text, a quarter of all,
// and the few others that these files have. Lacks() tells when a text needs more. What no font has
// (Chinese, say) is a narrow empty box.
//
//   const auto fonts = std::make_shared<const Fonts>(1);
//   ImGuiContext* const context = fonts->MakeContext();
#ifndef COPPICE_EDITOR_THEME_FONTS_H_
#define COPPICE_EDITOR_THEME_FONTS_H_

#include <imgui.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::editor {

enum class Face { kSans, kBold, kMono };

/// ASCII and what the editor itself writes, or all of them.
enum class Characters { kUsual, kAll };

/// The characters of a text in UTF-8 that are not usual ones, but among all; rising.
std::vector<ImWchar> UnusualCharacters(std::string_view text);

class Fonts {
 public:
  /// Bakes them for a screen of that scale (1 is an ordinary one): these characters, and `more`.
  explicit Fonts(float scale, Characters characters = Characters::kAll,
                 const std::vector<ImWchar>& more = {});

  float scale() const { return scale_; }
  Characters characters() const { return characters_; }

  /// Whether what is drawn has a character that these fonts lack and others would have: a square
  /// stands in its place.
  bool Lacks(const ImDrawData& drawn) const;
  /// The same of a text in UTF-8, which need not be drawn yet.
  bool Lacks(std::string_view text) const;

  /// Which file is missing, or empty. With an error, do not use them.
  const std::string& error() const { return error_; }

  /// A context of Dear ImGui that writes with these fonts; the current one stays what it is. The
  /// caller destroys it, before the fonts and on the thread of other contexts with these fonts.
  ImGuiContext* MakeContext() const;

  /// From its next frame on, the current context writes with these; between frames.
  void UseInContext() const;

  /// The largest baked font that is not larger than `pixels`; the smallest if all are larger.
  ImFont* Pick(Face face, float pixels) const;

 private:
  std::string Load(const std::vector<ImWchar>& more);
  void MarkMissing();

  const float scale_;
  const Characters characters_;
  struct {
    std::string sans, bold, mono, icons;
  } files_;  // the atlas points into them
  std::unique_ptr<ImFontAtlas> atlas_;
  std::string error_;
  ImFont* usual_ = nullptr;
  std::vector<ImFont*> sans_, bold_, mono_;  // by rising size
  std::vector<float> sizes_;                 // theirs, in pixels
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_FONTS_H_
