// The nodes that somebody has chosen (node_hooks.h): they are dispatched as kHooked in a copy of
// the program's records, so the others pay nothing.
#ifndef COPPICE_BT_CORE_ENGINE_HOOKED_NODES_H_
#define COPPICE_BT_CORE_ENGINE_HOOKED_NODES_H_

#include <algorithm>
#include <vector>

#include "bt_core/engine/node_hooks.h"
#include "bt_core/engine/program.h"

namespace coppice {

class HookedNodes {
 public:
  /// Null, or no nodes: none is chosen. Returns the records to tick by. While nodes are chosen
  /// these stay where they are, so that this may be called from within a hook.
  const NodeRecord* Choose(NodeHooks* hooks, const std::vector<NodeIndex>& nodes,
                           const Program& program) {
    hooks_ = hooks;
    records_.clear();
    if (!hooks || nodes.empty()) return program.nodes.data();
    records_ = program.nodes;
    for (const NodeIndex node : nodes) {
      if (node < records_.size()) records_[node].dispatch = NodeType::kHooked;
    }
    return records_.data();
  }

  NodeHooks* hooks() const { return hooks_; }

  /// A node that a hook has made RUNNING has begun nothing: it pretends.
  void Pretend(NodeIndex node) { pretending_.push_back(node); }
  const std::vector<NodeIndex>& pretending() const { return pretending_; }
  /// True if it did.
  bool StopPretending(NodeIndex node) {
    if (pretending_.empty()) return false;
    const auto at = std::find(pretending_.begin(), pretending_.end(), node);
    if (at == pretending_.end()) return false;
    pretending_.erase(at);
    return true;
  }

 private:
  NodeHooks* hooks_ = nullptr;
  std::vector<NodeRecord> records_;
  std::vector<NodeIndex> pretending_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_HOOKED_NODES_H_
