// The fonts of the editor, baked at a ladder of sizes so that text is crisp at every zoom.
//
// DejaVu Sans, Sans Bold and Sans Mono, with the icons of Font Awesome merged into the first two.
#ifndef COPPICE_EDITOR_LOOK_FONTS_H_
#define COPPICE_EDITOR_LOOK_FONTS_H_

#include <imgui.h>

#include <string>
#include <vector>

namespace coppice::editor {

enum class Face { kSans, kBold, kMono };

class Fonts {
 public:
  /// Adds all fonts to the atlas of the current ImGui context and builds it. `scale` is that of the
  /// screen (1 on an ordinary one). Returns an empty string, or which file is missing.
  std::string Load(float scale);

  /// The largest baked font that is not larger than `pixels`; the smallest if all are larger.
  ImFont* Pick(Face face, float pixels) const;

 private:
  std::vector<ImFont*> sans_, bold_, mono_;  // by rising size
  std::vector<float> sizes_;                 // theirs, in pixels
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LOOK_FONTS_H_
