// Nodes whose ports are scripts (docs/scripts.md).
//
//   Script           runs the script; SUCCESS
//   ScriptCondition  SUCCESS if the script's value is true, else FAILURE
//   Precondition     if the script's value is true, ticks the child and passes its result on; else
//                    the port `else`
//
// Precondition asks in every tick in which its child is not RUNNING, and not while it is. A script
// that cannot be run fails the node. Source: BehaviorTree.CPP 4, whose Precondition does not ask
// again after a halt.
#ifndef COPPICE_BT_CORE_NODES_SCRIPT_NODES_H_
#define COPPICE_BT_CORE_NODES_SCRIPT_NODES_H_

#include "bt_core/nodes/children.h"
#include "bt_core/nodes/result_port.h"

namespace coppice {

template <class Tree>
Status TickScript(Tree& tree, NodeIndex node) {
  tree.RunScript(node, 0);
  return Status::kSuccess;
}

template <class Tree>
Status TickScriptCondition(Tree& tree, NodeIndex node) {
  return tree.TestScript(node, 0) ? Status::kSuccess : Status::kFailure;
}

template <class Tree>
Status TickPrecondition(Tree& tree, NodeIndex node) {
  const bool child_runs = tree.status(node + 1) == Status::kRunning;
  if (!child_runs && !tree.TestScript(node, 0)) return internal::ResultPort(tree, node, 1);
  return internal::PassOn(tree, node, tree.Tick(node + 1));
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_SCRIPT_NODES_H_
