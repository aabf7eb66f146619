// What the inspector shows: the selected node, or without one the tree; in the place of both the
// model of a type while it is edited. Each draws its rows into the current panel.
#ifndef COPPICE_EDITOR_PANELS_INSPECTOR_PAGES_H_
#define COPPICE_EDITOR_PANELS_INSPECTOR_PAGES_H_

#include <string>

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// The selected node; there must be one.
void DrawNodePage(const Ui& ui, EditorState& state);

/// The shown tree: its ID, and what it shares with those who use it. "inspector/interface/NAME".
void DrawTreePage(const Ui& ui, EditorState& state);

/// The model of `state.inspector.type`: "inspector/type/kind", "inspector/type/port/0/name".
void DrawTypePage(const Ui& ui, EditorState& state);

/// A row that opens the model of a type, and makes it if there is none. "inspector/edit_type".
void DrawTypeAction(const Ui& ui, EditorState& state, const std::string& type);

/// A row with words to click. True if they were.
bool ActionRow(const Ui& ui, const std::string& path, std::string_view words);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_INSPECTOR_PAGES_H_
