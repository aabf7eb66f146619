#include "editor/live/values/port_values.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "editor/live/values/value_cache.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kMostBytes = 80;

using SlotsByKey = std::map<std::pair<std::string_view, std::string_view>, SlotIndex>;

// A port of a leaf knows its slot, wherever its key leads. Else the key is looked for where the
// node is: of a SubTree the ports lead out of it.
SlotIndex SlotOf(const PortLine& port, const SceneNode& node, const Scene& scene,
                 const TreeDescription& tree, const SlotsByKey& keys) {
  if (port.key.empty()) return kNoSlot;
  if (node.run_node < tree.nodes.size()) {
    for (const DescribedPort& described : tree.nodes[node.run_node].ports) {
      if (described.name == port.name) return described.slot;
    }
  }
  if (node.scope >= scene.scopes.size()) return kNoSlot;
  const auto found = keys.find({scene.scopes[node.scope], port.key});
  return found != keys.end() ? found->second : kNoSlot;
}

SlotsByKey KeysOf(const TreeDescription& tree) {
  SlotsByKey keys;
  for (SlotIndex slot{0}; slot < tree.slots.size(); ++slot) {
    const DescribedSlot& described = tree.slots[slot];
    if (described.has_key) keys[{described.scope, described.name}] = slot;
  }
  return keys;
}

std::vector<SlotIndex> SlotsOfPorts(const Scene& scene, const TreeDescription& tree) {
  std::vector<SlotIndex> slots(scene.ports.size(), kNoSlot);
  const SlotsByKey keys = KeysOf(tree);
  for (const SceneNode& node : scene.nodes) {
    for (std::uint32_t i = 0; i < node.port_count; ++i) {
      const std::uint32_t port = node.first_port + i;
      slots[port] = SlotOf(scene.ports[port], node, scene, tree, keys);
    }
  }
  return slots;
}

}  // namespace

void PortValues::Look(const RunView& run, const std::shared_ptr<const Scene>& scene) {
  values_ = nullptr;
  if (!run.tree() || !run.run().has_tree()) return;
  const std::shared_ptr<const TreeDescription>& tree = run.tree()->description();
  if (scene_ != scene || tree_ != tree) slots_ = SlotsOfPorts(*scene, *tree);
  scene_ = scene;
  tree_ = tree;
  values_ = &run.follower().values();
}

std::string PortValues::Of(std::uint32_t port) const {
  if (!values_ || port >= slots_.size() || slots_[port] >= values_->size()) return {};
  const std::string& bytes = (*values_)[slots_[port]];
  if (bytes.empty()) return {};
  std::string text = PrintBeginning(bytes, kMostBytes);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace coppice::editor
