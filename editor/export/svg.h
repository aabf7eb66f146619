// A Drawing as SVG 1.1. Texts stay texts, so that they can be found and copied; icons are outlines,
// so that nobody needs their font.
#ifndef COPPICE_EDITOR_EXPORT_SVG_H_
#define COPPICE_EDITOR_EXPORT_SVG_H_

#include <string>

#include "editor/export/drawing.h"
#include "editor/export/glyphs.h"

namespace coppice::editor {

std::string ToSvg(const Drawing& drawing, const Glyphs& glyphs);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_SVG_H_
