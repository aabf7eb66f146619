#include "tests/editor/shared_fonts.h"

#include <map>
#include <utility>

namespace coppice::editor {

std::shared_ptr<const Fonts> SharedFonts(float scale) {
  static std::map<float, std::shared_ptr<const Fonts>> baked;
  std::shared_ptr<const Fonts>& fonts = baked[scale];
  if (!fonts) fonts = std::make_shared<const Fonts>(scale, Alphabets());
  return fonts;
}

EditorOptions WithSharedFonts(EditorOptions options) {
  if (!options.fonts) options.fonts = SharedFonts(options.scale);
  return options;
}

}  // namespace coppice::editor
