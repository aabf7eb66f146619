// The edits of elements: each says which bytes of a document must change, and nothing else changes.
// Indentation, line ends and quotes are taken from the text around; values are escaped.
//
//   Edit edit = InsertElement(document, sequence, 2, "<Delay delay_msec=\"500\"><Beep/></Delay>");
//   document = *document.Edited(edit, diagnostics);
//
// Tags must be XML names (IsXmlName) and XML text must be one well-formed element; otherwise
// Document::Edited returns nothing. Positions count the element children of a parent from 0; a
// position behind the last is the end. What makes no sense, such as removing the root element, is
// an empty Edit. Element indices are those of the document given; afterwards, find an element again
// with MapOffset and Document::ElementAt.
#ifndef COPPICE_BT_CORE_MODEL_ELEMENT_EDITS_H_
#define COPPICE_BT_CORE_MODEL_ELEMENT_EDITS_H_

#include <cstdint>
#include <string_view>

#include "bt_core/model/document.h"
#include "bt_core/model/edit.h"

namespace coppice {

/// Changes the name in start tag and end tag.
Edit SetTag(const Document& document, ElementIndex element, std::string_view tag);

/// Puts XML text in as a child, on lines of its own if its neighbours stand so. The text's lines
/// keep their indentation relative to its last line.
Edit InsertElement(const Document& document, ElementIndex parent, std::uint32_t position,
                   std::string_view xml);

/// Removes the element, and its lines if nothing else stands on them.
Edit RemoveElement(const Document& document, ElementIndex element);

/// Moves the element with all that is in it. `position` counts without the element itself. Empty if
/// it is there already, or if the new parent lies in the element.
Edit MoveElement(const Document& document, ElementIndex element, ElementIndex new_parent,
                 std::uint32_t position);

/// Puts XML text in the place of the element.
Edit ReplaceElement(const Document& document, ElementIndex element, std::string_view xml);

/// Makes `count` siblings, with what stands between them, the children of a new element.
Edit WrapElements(const Document& document, ElementIndex first, std::uint32_t count,
                  std::string_view tag);

/// Puts the children of the element, with what stands between them, in its place.
Edit UnwrapElement(const Document& document, ElementIndex element);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_ELEMENT_EDITS_H_
