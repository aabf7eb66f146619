// One line of XML in colours.
#ifndef COPPICE_EDITOR_PANELS_XML_XML_LINE_H_
#define COPPICE_EDITOR_PANELS_XML_XML_LINE_H_

#include <string_view>

#include "editor/theme/ui.h"

namespace coppice::editor {

/// Of all lines of a text.
inline constexpr TextStyle kXmlStyle{Face::kMono, 11, 0};

/// Tags, values and comments in colours of their own; a comment over several lines is coloured in
/// its first line only. `row` is where to stop.
void PaintXmlLine(const Ui& ui, std::string_view line, Point at, const Box& row);

/// How far to the right the byte of the line begins.
float XmlColumn(const Ui& ui, std::string_view line, std::size_t byte);

/// The byte of the line that begins nearest to `x`.
std::size_t XmlByteAt(const Ui& ui, std::string_view line, float x);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_XML_XML_LINE_H_
