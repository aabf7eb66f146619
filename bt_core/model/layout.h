// How a file is laid out: its line ends and its indentation, so that new text looks like the text
// around it.
#ifndef COPPICE_BT_CORE_MODEL_LAYOUT_H_
#define COPPICE_BT_CORE_MODEL_LAYOUT_H_

#include <optional>
#include <string>
#include <string_view>

#include "bt_core/model/document.h"
#include "bt_core/model/edit.h"

namespace coppice {

/// "\n" or "\r\n": what ends the line before the offset, or the first line.
std::string_view LineEndAt(std::string_view text, std::size_t offset);

/// The blanks from the start of the line to the offset; nothing if there is something else.
std::optional<std::string_view> IndentationAt(std::string_view text, std::size_t offset);

/// How much deeper a child of this element stands: as its children, its siblings or else the first
/// nested elements of the document do. Two spaces if there is nothing to follow.
std::string_view IndentationStep(const Document& document, ElementIndex element);

/// The offset of the end tag's '<'. Undefined for a self-closing element.
std::size_t EndTagOffset(const Document& document, const Element& element);

/// Removes these bytes and what would be left of nothing: their lines if nothing else stands on
/// them, or the blanks before them at the end of a line.
Splice RemovalOfLine(std::string_view text, std::size_t begin, std::size_t end);

/// XML text moved from one indentation to another. Line ends become `line_end`. Attribute values,
/// comments and CDATA are left alone: their blanks may matter.
std::string Reindent(std::string_view xml, std::string_view from, std::string_view to,
                     std::string_view line_end);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_LAYOUT_H_
