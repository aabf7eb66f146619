// The open menus, over everything else. What is in them: commands/menus.h.
#ifndef COPPICE_EDITOR_PANELS_MENU_MENU_H_
#define COPPICE_EDITOR_PANELS_MENU_MENU_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Draws the open menu and its submenus behind all tiles, and takes the mouse as long as there is
/// one. Entries are "menu/COMMAND", each window "menu/window/LEVEL".
void DrawMenus(const Ui& ui, EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_MENU_MENU_H_
