// Where buttons go that belong to a node: beside it, and over as little as possible of the others.
#ifndef COPPICE_EDITOR_CANVAS_FREE_PLACE_H_
#define COPPICE_EDITOR_CANVAS_FREE_PLACE_H_

#include <vector>

#include "editor/canvas/tree_view.h"

namespace coppice::editor {

/// Below, above, right or left of `node`, so far from it, and inside of the canvas; the first of
/// these of which least of `others` is hidden. All in pixels of the screen.
Box FreePlaceBeside(const Box& node, Point size, float gap, const Box& canvas,
                    const std::vector<Box>& others);

/// The same for shown()[k] of a view that fills the canvas.
Box FreePlaceBeside(const TreeView& view, std::uint32_t k, Point size, float gap, const Box& canvas,
                    double now);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_FREE_PLACE_H_
