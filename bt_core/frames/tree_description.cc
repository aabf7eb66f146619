#include "bt_core/frames/tree_description.h"

#include <algorithm>
#include <random>
#include <unordered_map>

#include "bt_core/base/hex.h"
#include "bt_core/base/version.h"
#include "bt_core/engine/compile/models.h"
#include "bt_core/engine/program.h"

namespace coppice {
namespace {

std::vector<DescribedPort> Ports(const Program& program, NodeIndex node) {
  std::vector<DescribedPort> ports;
  const Registry::Entry* const entry = program.info[node].entry;
  if (!entry) return ports;
  const std::uint32_t first = program.FirstPort(node);
  for (std::uint32_t k = 0; k < entry->declarations.size(); ++k) {
    const SlotIndex slot = program.ports[first + k].slot;
    if (slot != kNoSlot) ports.push_back({entry->declarations[k].name, slot});
  }
  return ports;
}

NodeCategory CategoryOf(const Program& program, NodeIndex node) {
  if (program.nodes[node].type == NodeType::kSubTree) return NodeCategory::kSubTree;
  const Registry::Entry* const entry = program.info[node].entry;
  return entry ? entry->manifest.category : NodeCategory::kAction;
}

void DescribeNodes(const Program& program, std::vector<DescribedNode>& nodes) {
  for (NodeIndex node{0}; node < program.nodes.size(); ++node) {
    const NodeInfo& info = program.info[node];
    nodes.push_back({program.Path(node), program.Id(node), CategoryOf(program, node),
                     RunsOneChild(program.nodes[node].type), info.parent,
                     program.trees[info.scope].document, info.element, Ports(program, node)});
  }
}

// A slot without key is named after the first port that is bound to it.
std::unordered_map<SlotIndex, std::string> PortNames(const std::vector<DescribedNode>& nodes) {
  std::unordered_map<SlotIndex, std::string> names;
  for (const DescribedNode& node : nodes) {
    for (const DescribedPort& port : node.ports) {
      names.emplace(port.slot, node.path + "." + port.name);
    }
  }
  return names;
}

void DescribeSlots(const Layout& layout, TreeDescription& tree) {
  auto names = PortNames(tree.nodes);
  for (SlotIndex slot{0}; slot < layout.slots.size(); ++slot) {
    const SlotDefinition& definition = layout.slots[slot];
    const bool has_key = !definition.key.empty();
    tree.slots.push_back({layout.scopes[definition.scope], has_key ? definition.key : names[slot],
                          definition.type ? definition.type->name : "any", has_key});
  }
}

std::string ClockName(const Clock& clock) {
  if (dynamic_cast<const WallClock*>(&clock)) return "wall";
  return dynamic_cast<const SimulatedClock*>(&clock) ? "simulated" : "own";
}

}  // namespace

RunId MakeRunId() {
  std::random_device random;
  RunId id;
  for (std::uint8_t& byte : id) byte = static_cast<std::uint8_t>(random());
  return id;
}

std::string ToString(const RunId& id) { return ToHex(id); }

bool TellsChangesOnly(const RunInfo& info) {
  return std::any_of(info.metadata.begin(), info.metadata.end(), [](const auto& entry) {
    return entry.first == kChangesOnly.first && entry.second == kChangesOnly.second;
  });
}

RunInfo BeginRun(const Clock& clock) {
  return {MakeRunId(), ClockName(clock), {}, clock.Now(), std::chrono::system_clock::now()};
}

TreeDescription DescribeTree(const Program& program, RunInfo info) {
  TreeDescription tree;
  tree.writer = std::string("Coppice ") + kVersion + ", compiler " __VERSION__;
  tree.info = std::move(info);
  tree.main_tree = program.trees.front().id;
  for (const SourceText& text : program.texts) {
    tree.documents.push_back({text.file(), text.text()});
  }
  tree.models = WriteModels(*program.registry);
  DescribeNodes(program, tree.nodes);
  DescribeSlots(program.layout, tree);
  return tree;
}

TreeShape ShapeOf(const TreeDescription& tree) {
  TreeShape shape;
  for (NodeIndex node{0}; node < tree.nodes.size(); ++node) {
    shape.push_back({tree.nodes[node].parent, node + 1, tree.nodes[node].runs_one_child});
  }
  for (auto node = static_cast<NodeIndex>(shape.size()); node-- > 1;) {
    NodeShape& parent = shape[shape[node].parent];
    parent.end = std::max(parent.end, shape[node].end);
  }
  return shape;
}

}  // namespace coppice
