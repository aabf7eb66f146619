// The ports of a node of the shown tree, as those see it who fill them in.
#ifndef COPPICE_EDITOR_WORKSPACE_NODE_PORTS_H_
#define COPPICE_EDITOR_WORKSPACE_NODE_PORTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// The ports that its type has. Those of a SubTree are what its tree shares; while a run is shown
/// that is not known.
std::vector<PortModel> PortsToGive(EditorState& state, const SceneNode& node, double now);

/// The names of these, then of what the node is given besides; without guards and hooks.
std::vector<std::string> PortNamesOf(EditorState& state, const Scene& scene, std::uint32_t node,
                                     double now);

/// The keys of the blackboard that the node sees, most used first.
std::vector<std::string> KeysSeenBy(const Scene& scene, const SceneNode& node);

/// Begins to edit that port of the selected node on the canvas.
void EditPort(EditorState& state, const std::string& port);
/// The item in which it is edited: "canvas/edit/1.2/goal".
std::string PortField(const SceneNode& node, const std::string& port);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_NODE_PORTS_H_
