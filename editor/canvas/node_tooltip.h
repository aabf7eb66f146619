// What the mouse shows of a node: type, status, description, and every port with type and meaning.
#ifndef COPPICE_EDITOR_CANVAS_NODE_TOOLTIP_H_
#define COPPICE_EDITOR_CANVAS_NODE_TOOLTIP_H_

#include "editor/live/tree_snapshot.h"
#include "editor/live/values/port_values.h"
#include "editor/scene/scene.h"
#include "editor/theme/ui.h"

namespace coppice::editor {

/// Draws it at the mouse, above everything else. `values`: of the keys in its ports; null: none.
void DrawNodeTooltip(const Ui& ui, const Scene& scene, const SceneNode& node,
                     const NodeState& state, const PortValues* values = nullptr);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CANVAS_NODE_TOOLTIP_H_
