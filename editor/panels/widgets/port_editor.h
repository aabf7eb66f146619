// A field over the canvas, at the row of a port of the selected node: what EditPort (workspace/
// node_ports.h) begins. Enter and a click elsewhere end it, Esc takes back what was typed, Tab goes
// to the next port and then to the next node, Shift+Tab back.
#ifndef COPPICE_EDITOR_PANELS_WIDGETS_PORT_EDITOR_H_
#define COPPICE_EDITOR_PANELS_WIDGETS_PORT_EDITOR_H_

#include "editor/theme/ui.h"
#include "editor/workspace/node_ports.h"

namespace coppice::editor {

/// Draws it, if a port is being edited, within the canvas. "canvas/edit/1.2/goal".
void DrawPortEditor(const Ui& ui, EditorState& state, const Box& canvas);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_WIDGETS_PORT_EDITOR_H_
