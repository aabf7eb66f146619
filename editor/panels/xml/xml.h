// The tile of the text, in which one can also write.
#ifndef COPPICE_EDITOR_PANELS_XML_XML_H_
#define COPPICE_EDITOR_PANELS_XML_XML_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// The text of the file, with the line of the selected node. "xml/LINE".
void DrawXml(const Ui& ui, EditorState& state, const Box& box);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_XML_XML_H_
