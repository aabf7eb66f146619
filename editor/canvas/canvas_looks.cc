#include "editor/canvas/canvas_looks.h"

#include <algorithm>

#include "editor/canvas/data_links.h"

namespace coppice::editor {
namespace {

// What runs and what is wrong below a collapsed node is seen on it.
void RollUp(const TreeView& view, const CanvasOptions& options, std::uint32_t node,
            NodeLook& look) {
  const auto& nodes = view.scene()->nodes;
  look.hidden = nodes[node].end - node - 1;
  look.hidden_status = look.state.status;
  for (std::uint32_t i = node + 1; i < nodes[node].end; ++i) {
    const Status status = StateOf(options.live, nodes[i]).status;
    if (status == Status::kRunning) look.hidden_status = status;
    look.hidden_badge = std::max(look.hidden_badge, BadgeOf(options, i));
    if (look.change == Change::kNone && ChangeOf(options, i) != Change::kNone) {
      look.change = Change::kChanged;
    }
  }
}

// The value by which the ports of a node that use the lit key name it.
std::string_view LitValue(const TreeView& view, const SceneNode& node) {
  if (view.lit_key() == kNoKey) return {};
  const auto index = static_cast<std::uint32_t>(&node - view.scene()->nodes.data());
  const std::vector<KeyUse>& uses = view.keys().uses[view.lit_key()];
  const auto use =
      std::lower_bound(uses.begin(), uses.end(), index,
                       [](const KeyUse& one, std::uint32_t at) { return one.node < at; });
  return use != uses.end() && use->node == index ? view.scene()->ports[use->port].value
                                                 : std::string_view();
}

}  // namespace

NodeState StateOf(const TreeSnapshot* live, const SceneNode& node) {
  if (!live || node.run_node >= live->states.size()) return {};
  return live->states[node.run_node];
}

Badge BadgeOf(const CanvasOptions& options, std::uint32_t node) {
  return options.badges && node < options.badges->size() ? (*options.badges)[node] : Badge::kNone;
}

Change ChangeOf(const CanvasOptions& options, std::uint32_t node) {
  return options.changes && node < options.changes->size() ? (*options.changes)[node]
                                                           : Change::kNone;
}

NodeLook LookOf(const TreeView& view, const CanvasOptions& options, std::uint32_t k, const Box& box,
                float zoom) {
  const std::uint32_t node = view.shown()[k];
  const SceneNode& scene_node = view.scene()->nodes[node];
  NodeLook look;
  look.box = box;
  look.zoom = zoom;
  look.state = StateOf(options.live, scene_node);
  look.selected = view.IsSelected(node);
  look.collapsed = view.IsCollapsed(node);
  look.name_only = view.names_only();
  look.whole_values = view.style().whole_values;
  look.offline = options.live && !options.live->is_fresh;
  look.badge = BadgeOf(options, node);
  look.change = ChangeOf(options, node);
  look.port_values = options.port_values;
  if (options.heat && node < options.heat->values.size()) {
    look.has_heat = true;
    look.heat = options.heat->values[node];
  }
  look.strength = IsLit(view, node) ? 1 : kDimmed;
  if (look.change == Change::kRemoved) look.strength = std::min(look.strength, 0.45F);
  look.lit_value = LitValue(view, scene_node);
  if (look.collapsed) RollUp(view, options, node, look);
  return look;
}

}  // namespace coppice::editor
