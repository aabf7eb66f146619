// Which text the XML tile shows, and what of it is marked.
#ifndef COPPICE_EDITOR_PANELS_XML_XML_SHOWN_H_
#define COPPICE_EDITOR_PANELS_XML_XML_SHOWN_H_

#include <cstdint>
#include <string>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

struct ShownXml {
  std::string path;
  const std::string* text = nullptr;   ///< null: none
  const Document* document = nullptr;  ///< of the text; null if that is malformed
  bool can_edit = false;
  std::uint32_t begin = 0;  ///< of the start tag of the selected node
  std::uint32_t end = 0;    ///< both 0: none
};

/// The file of the selected node, else of the shown tree; of a malformed file its text.
ShownXml ChooseXml(const EditorState& state, const TreeView* view);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_XML_XML_SHOWN_H_
