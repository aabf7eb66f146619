// Stops a tree at chosen nodes or decides for them: breakpoints and injected faults. Nodes that
// nobody has chosen cost nothing.
#ifndef COPPICE_BT_CORE_ENGINE_NODE_HOOKS_H_
#define COPPICE_BT_CORE_ENGINE_NODE_HOOKS_H_

#include <optional>

#include "bt_core/base/status.h"
#include "bt_core/nodes/control.h"

namespace coppice {

/// Given to Executor::SetHooks. Called on the ticking thread; each call may block, and the tree
/// stands still meanwhile (Executor::ReportSoFar lets the watchers see how far it came).
class NodeHooks {
 public:
  virtual ~NodeHooks() = default;

  /// Before every tick, also if no node is chosen.
  virtual void BeforeTick() {}

  /// Before a chosen node is ticked, and after its guards have let it. A status is the node's
  /// result without a tick; if it was RUNNING and this is not, it is halted first. A node that has
  /// begun nothing and is said to be RUNNING begins when it is ticked, and is not told of a halt.
  virtual std::optional<Status> Before(NodeIndex node) = 0;

  /// After it was ticked. A status takes the place of its result; if the node is RUNNING and the
  /// status is not, it is halted.
  virtual std::optional<Status> After(NodeIndex node, Status result) = 0;

  /// At the end of Executor::Reload, which has taken the hooks away: nodes have new numbers.
  virtual void OnReload() {}
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_NODE_HOOKS_H_
