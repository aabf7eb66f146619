// Drag and drop on the canvas: what a drop means for the tree, and whether it is allowed. Every
// drop is one named step of the history.
#ifndef COPPICE_EDITOR_CORE_CANVAS_DROPS_H_
#define COPPICE_EDITOR_CORE_CANVAS_DROPS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "editor/canvas/drop_target.h"

namespace coppice::editor {

struct EditorState;

/// The last answer: the same question is asked in every frame.
struct DropCheck {
  DropRequest request;
  std::vector<std::uint32_t> nodes;    ///< that were selected
  std::uint64_t version = UINT64_MAX;  ///< of the project; none yet
  std::string why_not;
};

/// Why the selected nodes cannot be dropped there, or empty. Tries the change on a copy.
std::string WhyNoDrop(EditorState& state, double now, const DropRequest& request);

/// Drops the selected nodes there.
void Drop(EditorState& state, double now, const DropRequest& request);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CORE_CANVAS_DROPS_H_
