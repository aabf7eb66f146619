// Where the minimap goes while something of the tree is out of sight: into a corner of the canvas
// where it lies over no node, else where it covers least, and then one sees through it.
#ifndef COPPICE_EDITOR_CANVAS_MINIMAP_H_
#define COPPICE_EDITOR_CANVAS_MINIMAP_H_

#include <vector>

#include "editor/theme/geometry.h"

namespace coppice::editor {

enum class Corner { kUpperRight, kLowerRight, kLowerLeft, kUpperLeft };

/// Of one view, from frame to frame.
struct MinimapState {
  Corner corner = Corner::kUpperRight;
  bool covers = false;       ///< nodes, because no corner is free
  bool holds_mouse = false;  ///< the mouse is on it or drags from it: it stays where it is
};

/// A box of that size in a corner of the canvas, so far from its edges. All in pixels.
Box InCorner(Corner corner, const Box& canvas, Point size, float margin);

struct CornerChoice {
  Corner corner;
  bool is_free;  ///< the box hides nothing there
};

/// The corner where the box hides least of the nodes: the present one rather than another that is
/// no better, then the first one.
CornerChoice FreestCorner(const Box& canvas, Point size, float margin,
                          const std::vector<Box>& nodes, Corner present);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_MINIMAP_H_
