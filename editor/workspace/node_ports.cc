#include "editor/workspace/node_ports.h"

#include <algorithm>
#include <map>

#include "bt_core/nodes/guards.h"
#include "editor/workspace/project_editor.h"

namespace coppice::editor {

std::vector<PortModel> PortsToGive(EditorState& state, const SceneNode& node, double now) {
  if (node.shape != Shape::kSubTree) {
    return node.model ? node.model->ports : std::vector<PortModel>();
  }
  std::vector<PortModel> ports;
  const ProjectFiles files = ProjectEditor(state, now).Files();
  const auto& shared = state.inspector.interfaces.Of(std::string(node.id), state.workspace, files);
  for (const InterfacePort& port : shared) ports.push_back(port.model);
  return ports;
}

std::vector<std::string> PortNamesOf(EditorState& state, const Scene& scene, std::uint32_t node,
                                     double now) {
  std::vector<std::string> names;
  for (const PortModel& port : PortsToGive(state, scene.nodes[node], now)) {
    names.push_back(port.name);
  }
  const std::uint32_t first = scene.nodes[node].first_port;
  for (std::uint32_t i = first; i < first + scene.nodes[node].port_count; ++i) {
    const std::string_view name = scene.ports[i].name;
    const bool known = std::find(names.begin(), names.end(), name) != names.end();
    if (!known && !IsGuardAttribute(name) && !IsReservedAttribute(name)) names.emplace_back(name);
  }
  return names;
}

std::vector<std::string> KeysSeenBy(const Scene& scene, const SceneNode& node) {
  std::map<std::string, int> uses;
  for (const SceneNode& other : scene.nodes) {
    if (other.scope != node.scope) continue;
    for (std::uint32_t i = 0; i < other.port_count; ++i) {
      const std::string_view key = scene.ports[other.first_port + i].key;
      if (!key.empty()) ++uses[std::string(key)];
    }
  }
  std::vector<std::string> keys;
  for (const auto& [key, count] : uses) keys.push_back(key);
  std::stable_sort(keys.begin(), keys.end(),
                   [&](const auto& a, const auto& b) { return uses[a] > uses[b]; });
  return keys;
}

std::string PortField(const SceneNode& node, const std::string& port) {
  return "canvas/edit/" + node.path + "/" + port;
}

void EditPort(EditorState& state, const std::string& port) {
  const TreeView& view = *state.workspace.view();
  state.input.focus_field = PortField(view.scene()->nodes[view.selected()], port);
}

}  // namespace coppice::editor
