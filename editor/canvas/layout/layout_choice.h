// Which layout a tree gets on a canvas: the first of these in which it can be read as a whole.
//
//   1. with its ports, top to bottom, then left to right
//   2. with its names alone, top to bottom, then left to right
//   3. with its names alone in rows that are broken where they are too long
//   4. with its names alone in rows that are broken where that takes the least room
//
// What cannot be read as a whole is laid out like a page: rows as long as the canvas is wide, to be
// scrolled. What the user has chosen (LayoutStyle) is left to him.
#ifndef COPPICE_EDITOR_CANVAS_LAYOUT_LAYOUT_CHOICE_H_
#define COPPICE_EDITOR_CANVAS_LAYOUT_LAYOUT_CHOICE_H_

#include "editor/canvas/layout/tree_layout.h"

namespace coppice::editor {

/// Least zooms at which nodes with their ports, and names that stand alone, can be read: names have
/// a size of 9 pixels there, and just fit into their boxes.
inline constexpr float kReadablePorts = 0.7F;
inline constexpr float kReadableNames = 0.42F;

struct ChosenLayout {
  LayoutChoice choice;
  TreeLayout layout;
  float readable = 1;       ///< least zoom at which it can be read
  bool can_be_read = true;  ///< as a whole on that canvas
};

/// `canvas`: room for the tree [pixels of a screen of scale 1]. A handful of layouts at most.
ChosenLayout ChooseLayout(const MeasuredTree& tree, const LayoutStyle& style, Point canvas);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_LAYOUT_LAYOUT_CHOICE_H_
