// The beginning of dragging something out of a tile.
#ifndef COPPICE_EDITOR_PANELS_DRAG_SOURCE_H_
#define COPPICE_EDITOR_PANELS_DRAG_SOURCE_H_

#include <imgui.h>

namespace coppice::editor {

/// True while the row that was drawn last is pressed and the mouse has left the place where that
/// began: a click is not a drag.
inline bool StartsDrag() {
  constexpr float kDistance = 4;
  return ImGui::IsItemActive() && ImGui::IsMouseDragging(0, kDistance);
}

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_DRAG_SOURCE_H_
