// Dropping onto the rows of the outline: at the upper or lower edge of a row among its siblings, in
// the middle into the node.
#ifndef COPPICE_EDITOR_PANELS_OUTLINE_DROP_H_
#define COPPICE_EDITOR_PANELS_OUTLINE_DROP_H_

#include <cstdint>

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Where something goes that is let go over the row of a node; `part` is 0 at the upper edge of the
/// row, 1 at the lower.
DropTarget OutlineTarget(const Scene& scene, std::uint32_t node, float part);

/// Marks the place, if something is dragged over the row, and drops it there when the button is let
/// go. What is not possible is said beside the mouse.
void DropOntoRow(const Ui& ui, EditorState& state, std::uint32_t node, const Box& row);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_OUTLINE_DROP_H_
