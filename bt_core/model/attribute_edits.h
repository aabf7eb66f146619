// The edits of attributes: each says which bytes of a document must change, and nothing else
// changes. Quotes and layout are taken from the attributes around; values are escaped.
//
//   Edit edit = SetAttribute(document, node, "msec", "500");
//
// Names must be XML names (IsXmlName).
#ifndef COPPICE_BT_CORE_MODEL_ATTRIBUTE_EDITS_H_
#define COPPICE_BT_CORE_MODEL_ATTRIBUTE_EDITS_H_

#include <string_view>

#include "bt_core/model/document.h"
#include "bt_core/model/edit.h"

namespace coppice {

/// Gives the attribute this value; empty if it has it already. A new attribute comes last; on a
/// line of its own if the last one has one. Line ends in the value stay line ends if the old value
/// had some, and become &#10; otherwise.
Edit SetAttribute(const Document& document, ElementIndex element, std::string_view name,
                  std::string_view value);

/// Removes the attribute with the blanks before it; empty if there is none.
Edit RemoveAttribute(const Document& document, ElementIndex element, std::string_view name);

/// Changes the name and leaves place and value alone; empty if there is no such attribute. There
/// must be none of the new name.
Edit RenameAttribute(const Document& document, ElementIndex element, std::string_view name,
                     std::string_view new_name);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_ATTRIBUTE_EDITS_H_
