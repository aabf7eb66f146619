// Trees into files. The ending of the name says the format:
//
//   .svg    shapes and texts that can be searched and copied; needs no font
//   .pdf    one page
//   .png    pixels
//   .dot    for Graphviz
//   .md     a nested list
#ifndef COPPICE_EDITOR_EXPORT_WRITE_PICTURE_H_
#define COPPICE_EDITOR_EXPORT_WRITE_PICTURE_H_

#include <optional>
#include <string>

#include "bt_core/base/outcome.h"
#include "editor/export/tree_picture.h"

namespace coppice::editor {

enum class PictureFormat : std::uint8_t { kSvg, kPdf, kPng, kDot, kMarkdown };

/// By the ending of the name, in any case of letters; nothing if it is none of the above.
std::optional<PictureFormat> FormatOf(const std::string& path);

/// The endings as a sentence: ".svg, .pdf, ...".
extern const char* const kPictureEndings;

/// Writes the file; a file that is there is replaced, or stays as it was if something goes wrong.
/// `pixels` are those of a PNG for one of the canvas at 100 %.
Outcome WritePicture(const TreePainting& painting, const std::string& path, float pixels);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_WRITE_PICTURE_H_
