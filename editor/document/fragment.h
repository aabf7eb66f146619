// Nodes as XML text: what the clipboard carries, to and from any text editor.
#ifndef COPPICE_EDITOR_DOCUMENT_FRAGMENT_H_
#define COPPICE_EDITOR_DOCUMENT_FRAGMENT_H_

#include <string>
#include <string_view>
#include <vector>

#include "bt_core/model/document.h"

namespace coppice::editor {

/// The text of these elements, one after the other, moved to the left edge.
std::string CopyText(const Document& document, const std::vector<ElementIndex>& elements);

/// The elements of a text, as pieces of it. The nodes of a whole file or of a <BehaviorTree> are
/// taken out of it. With errors in `diagnostics` nothing is returned; they name "clipboard" and the
/// line of the text.
std::vector<std::string> ReadFragments(std::string_view text, Diagnostics& diagnostics);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_FRAGMENT_H_
