// The ticks of the built-in nodes that are not in the innermost loop (executor.cc has those).
#include "bt_core/engine/executor.h"
#include "bt_core/nodes/decorator.h"

namespace coppice {

Status Executor::DispatchOthers(NodeIndex node, NodeType type) {
  switch (type) {
    case NodeType::kParallel:
      return TickParallel(*this, node);
    case NodeType::kRepeat:
      return TickRepeat(*this, node);
    case NodeType::kRetryUntilSuccessful:
      return TickRetryUntilSuccessful(*this, node);
    case NodeType::kTimeout:
      return TickTimeout(*this, node);
    default:
      return TickDelay(*this, node);
  }
}

}  // namespace coppice
