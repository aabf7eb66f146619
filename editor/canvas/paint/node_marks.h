// What is stuck onto a node: the note above it, the badge of a problem, the chip that stands for
// collapsed children, the mark of a change, the bar of its heat, breakpoints.
#ifndef COPPICE_EDITOR_CANVAS_PAINT_NODE_MARKS_H_
#define COPPICE_EDITOR_CANVAS_PAINT_NODE_MARKS_H_

#include "editor/canvas/paint/node_look.h"
#include "editor/canvas/paint/pen.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

/// The lines of a note as they are shown: at most two, the second one cut.
std::vector<std::string> NoteLines(std::string_view note);

void PaintNote(Pen& pen, const SceneNode& node, const NodeLook& look);
void PaintBadge(Pen& pen, const NodeLook& look, const Box& body);
void PaintChip(Pen& pen, const NodeLook& look);
void PaintHeat(Pen& pen, const NodeLook& look, const Box& body);
/// A stripe beside the node with "+", "-", an arrow or "~"; if only its name is shown, its
/// neighbours are too near for that: a square on its upper left corner.
void PaintChange(Pen& pen, const NodeLook& look, const Box& body);

/// Breakpoints, where the tree stands, faults. Shape first: a disc is a breakpoint, hollow if it is
/// switched off, a second ring where the tree stands; a flag with an exclamation mark is a fault.
void PaintMarks(Pen& pen, const NodeLook& look);

/// The colour of a change, of nodes at rest if there is none.
Color ColorOf(const Palette& palette, Change change);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_PAINT_NODE_MARKS_H_
