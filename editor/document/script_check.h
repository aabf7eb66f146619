// Are the scripts of a node well written? Asks the engine's own compiler, without knowing the keys
// of the tree.
#ifndef COPPICE_EDITOR_DOCUMENT_SCRIPT_CHECK_H_
#define COPPICE_EDITOR_DOCUMENT_SCRIPT_CHECK_H_

#include <string>
#include <string_view>

namespace coppice::editor {

/// "column 5: message (hint)", or empty.
std::string ScriptProblemOf(std::string_view script);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_SCRIPT_CHECK_H_
