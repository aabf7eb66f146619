// From the options of a canvas to the look of each node: its state, its marks, what it hides.
#ifndef COPPICE_EDITOR_CANVAS_CANVAS_LOOKS_H_
#define COPPICE_EDITOR_CANVAS_CANVAS_LOOKS_H_

#include "editor/canvas/canvas.h"

namespace coppice::editor {

/// How shown()[k] looks in that box at that zoom. `hovered` is left false.
NodeLook LookOf(const TreeView& view, const CanvasOptions& options, std::uint32_t k, const Box& box,
                float zoom);

Badge BadgeOf(const CanvasOptions& options, std::uint32_t node);
Change ChangeOf(const CanvasOptions& options, std::uint32_t node);

/// How strong nodes and lines are that the user has not asked about.
inline constexpr float kDimmed = 0.25F;

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_CANVAS_LOOKS_H_
