// Between the numbers and the text of the XML tile: a bar for what is not saved, and beside it one
// for what is not committed. Registers "xml/unsaved/LINE" and "xml/uncommitted/LINE".
#ifndef COPPICE_EDITOR_PANELS_XML_XML_GUTTER_H_
#define COPPICE_EDITOR_PANELS_XML_XML_GUTTER_H_

#include <cstddef>
#include <string>

#include "editor/panels/widgets/panel.h"
#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

inline constexpr float kXmlNumberWidth = 50;  ///< with the bars; pixels at scale 1

/// Compares the text of that file anew if it, the saved text or that in git is another one.
void UpdateXmlGutter(EditorState& state, const std::string& path);

/// `line` counts from 0.
void DrawXmlGutter(const Ui& ui, const XmlGutter& gutter, std::size_t line, const Row& row);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_XML_XML_GUTTER_H_
