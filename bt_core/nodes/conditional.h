// Nodes that choose a branch by the result of their first child.
//
//   first child   IfThenElse                      WhileDoElse
//   SUCCESS       ticks the second child          halts the third child, ticks the second
//   FAILURE       ticks the third child; FAILURE  halts the second child, ticks the third; FAILURE
//                 if there is none                if there is none
//   RUNNING       RUNNING                         RUNNING; a running branch is left as it is
//   SKIPPED       SKIPPED                         halts the branch, SKIPPED
//
// The branch's result is theirs. IfThenElse asks once in an activation, WhileDoElse in every tick.
// Source: BehaviorTree.CPP 4, which throws where the first child is skipped.
#ifndef COPPICE_BT_CORE_NODES_CONDITIONAL_H_
#define COPPICE_BT_CORE_NODES_CONDITIONAL_H_

#include "bt_core/nodes/children.h"

namespace coppice {
namespace internal {

template <class Tree>
Status TickBranch(Tree& tree, NodeIndex node, NodeIndex branch) {
  const Status result = tree.Tick(branch);
  return result == Status::kRunning ? result : End(tree, node, result);
}

// The branch for a result of the first child that is not RUNNING; the end of the node for none.
template <class Tree>
NodeIndex BranchFor(const Tree& tree, NodeIndex node, Status condition) {
  const NodeIndex then = tree.EndOf(node + 1);
  if (condition == Status::kSuccess) return then;
  return condition == Status::kFailure ? tree.EndOf(then) : tree.EndOf(node);
}

}  // namespace internal

/// Memory: the branch that was chosen.
template <class Tree>
Status TickIfThenElse(Tree& tree, NodeIndex node) {
  if (tree.memory(node) == 0) {
    const Status condition = tree.Tick(node + 1);
    if (condition == Status::kRunning) return condition;
    const NodeIndex branch = internal::BranchFor(tree, node, condition);
    if (branch == tree.EndOf(node)) return internal::End(tree, node, condition);
    tree.memory(node) = branch;
  }
  return internal::TickBranch(tree, node, static_cast<NodeIndex>(tree.memory(node)));
}

template <class Tree>
Status TickWhileDoElse(Tree& tree, NodeIndex node) {
  const Status condition = tree.Tick(node + 1);
  if (condition == Status::kRunning) return condition;
  const NodeIndex branch = internal::BranchFor(tree, node, condition);
  if (branch == tree.EndOf(node)) return internal::End(tree, node, condition);
  for (NodeIndex child = tree.EndOf(node + 1); child != tree.EndOf(node);
       child = tree.EndOf(child)) {
    if (child != branch) tree.Halt(child);
  }
  return internal::TickBranch(tree, node, branch);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_CONDITIONAL_H_
