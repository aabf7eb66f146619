// A Drawing as a PDF 1.4 of one page. Texts are outlines, so that no font need be embedded.
#ifndef COPPICE_EDITOR_EXPORT_PDF_H_
#define COPPICE_EDITOR_EXPORT_PDF_H_

#include <string>

#include "editor/export/drawing.h"
#include "editor/export/glyphs.h"

namespace coppice::editor {

/// A pixel becomes 0.75 points; a picture longer than PDF allows (14400 points) is made smaller.
std::string ToPdf(const Drawing& drawing, const Glyphs& glyphs);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_PDF_H_
